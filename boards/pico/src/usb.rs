//! Receives scenes over USB. The host sees the board as a serial port (CDC ACM).
//!
//! The firmware may take longer to trace a line than the USB timeouts of the host allow. An
//! interrupt handler therefore serves the USB connection. While a picture is drawn, the
//! firmware processes received scenes every few milliseconds, see [`Input`](crate::input::Input).

use core::cell::RefCell;
use core::fmt::{self, Write};

use critical_section::Mutex;
use rp2040_hal::Timer;
use rp2040_hal::fugit::MicrosDurationU64;
use rp2040_hal::pac::{self, interrupt};
use rp2040_hal::timer::Instant;
use rp2040_hal::usb::UsbBus;
use scene_serial::{Answer, Message, Receiver};
use usb_device::bus::UsbBusAllocator;
use usb_device::device::{StringDescriptors, UsbDevice, UsbDeviceBuilder, UsbVidPid};
use usbd_serial::{SerialPort, USB_CLASS_CDC};
use whitted::DecodeError;

/// Capacity of the USB receiver in bytes. A scene must fit together with its ticket and
/// checksum.
pub(crate) const CAPACITY: usize = 16 * 1024;

/// Time without data after which a transfer is aborted.
const TIMEOUT: MicrosDurationU64 = MicrosDurationU64::secs(1);

/// USB vendor ID and product ID. Every CDC ACM serial port may use these two IDs.
const VENDOR_PRODUCT: UsbVidPid = UsbVidPid(0x16C0, 0x27DD);

/// State of the USB connection. The interrupt handler and the main loop share it.
static LINK: Mutex<RefCell<Option<Link>>> = Mutex::new(RefCell::new(None));

/// USB serial connection, with the receiver that decodes the incoming scenes.
struct Link {
    device: UsbDevice<'static, UsbBus>,
    port: Port,
    receiver: &'static mut SceneReceiver,
    timer: Timer,
    /// Time of the last received byte.
    last_received: Instant,
}

/// Receiver that decodes scenes sent over USB.
pub(crate) type SceneReceiver = Receiver<CAPACITY>;

/// USB serial port. Its transmit buffer of 256 bytes is large enough for the longest
/// answer.
type Port = SerialPort<'static, UsbBus, [u8; 128], [u8; 256]>;

/// Starts the USB device. Must be called only once.
pub(crate) fn start(bus: UsbBus, receiver: &'static mut SceneReceiver, timer: Timer) {
    let allocator = cortex_m::singleton!(: UsbBusAllocator<UsbBus> = UsbBusAllocator::new(bus));
    let bus = allocator.expect("the board is initialized once");
    let port = SerialPort::new_with_store(bus, [0; 128], [0; 256]);
    let names = StringDescriptors::default()
        .manufacturer("whitted")
        .product("Pico with a display");
    let device = UsbDeviceBuilder::new(bus, VENDOR_PRODUCT)
        .strings(&[names])
        .and_then(|builder| builder.max_packet_size_0(64))
        .expect("the USB strings and packet size are valid")
        .device_class(USB_CLASS_CDC)
        .build();
    let link = Link {
        device,
        port,
        receiver,
        timer,
        last_received: timer.get_counter(),
    };
    critical_section::with(|cs| LINK.replace(cs, Some(link)));
    // SAFETY: no critical section masks this interrupt in the NVIC, so unmasking it here is
    // sound.
    unsafe { cortex_m::peripheral::NVIC::unmask(pac::Interrupt::USBCTRL_IRQ) }
}

#[interrupt]
fn USBCTRL_IRQ() {
    with_link(Link::poll);
}

/// Validates a received scene with the closure `check` and sends the answer to the host.
///
/// Returns true if a scene arrived and is valid. The receiver then keeps the scene until
/// [`take`] is called.
pub(crate) fn receive(check: impl FnOnce(&[u8]) -> Result<(), DecodeError>) -> bool {
    with_link(|link| link.process(check)).unwrap_or(false)
}

/// Passes the received scene to the closure `store` and removes it from the receiver.
pub(crate) fn take(store: impl FnOnce(&[u8])) {
    with_link(|link| {
        if let Some(message) = link.receiver.message() {
            store(message.scene);
        }
        link.receiver.forget();
    });
}

/// Calls `act` with the USB connection while interrupts are disabled.
///
/// Returns `None` if [`start`] has not been called.
fn with_link<R>(act: impl FnOnce(&mut Link) -> R) -> Option<R> {
    critical_section::with(|cs| LINK.borrow_ref_mut(cs).as_mut().map(act))
}

impl Link {
    /// Handles pending USB events and passes the received bytes to the receiver.
    fn poll(&mut self) {
        if !self.device.poll(&mut [&mut self.port]) {
            return;
        }
        let mut packet = [0; 64];
        while let Ok(length) = self.port.read(&mut packet) {
            self.last_received = self.timer.get_counter();
            for byte in packet.iter().take(length) {
                if let Some(Err(why)) = self.receiver.receive(*byte) {
                    self.answer(Answer::Broken { why });
                }
            }
        }
    }

    /// If a message is complete, checks its scene with `check` and sends the answer to the
    /// host. If a transfer has stalled, aborts it. Returns true if a message with a valid
    /// scene arrived.
    fn process(&mut self, check: impl FnOnce(&[u8]) -> Result<(), DecodeError>) -> bool {
        let Some(Message { ticket, scene }) = self.receiver.message() else {
            let silence = self.timer.get_counter() - self.last_received;
            if silence > TIMEOUT
                && let Some(why) = self.receiver.forget()
            {
                self.answer(Answer::Broken { why });
            }
            return false;
        };
        let checked = check(scene);
        if checked.is_err() {
            self.receiver.forget();
        }
        self.answer(match checked {
            Ok(()) => Answer::Shown { ticket },
            Err(why) => Answer::Refused { ticket, why },
        });
        checked.is_ok()
    }

    /// Sends an answer to the host. If the host does not read its answers, text that does
    /// not fit into the transmit buffer is lost.
    fn answer(&mut self, answer: Answer<impl fmt::Display>) {
        _ = writeln!(TextOutput(&mut self.port), "{answer}");
    }
}

/// Writes text to the USB serial port.
struct TextOutput<'p>(&'p mut Port);

impl Write for TextOutput<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.write(text.as_bytes()).map_err(|_| fmt::Error)?;
        Ok(())
    }
}
