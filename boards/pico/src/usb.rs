//! Scenes that come over USB, which is a serial port to the host.
//!
//! A line may take longer to trace than a host waits. So an interrupt keeps the
//! connection and receives; what came is looked at between lines.

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

/// Room for a scene, its ticket and its checksum.
pub(crate) const ROOM: usize = 16 * 1024;

/// A transfer that does not go on for so long is given up.
const PATIENCE: MicrosDurationU64 = MicrosDurationU64::secs(1);

/// That of serial ports of whoever has no number of their own.
const VENDOR_PRODUCT: UsbVidPid = UsbVidPid(0x16C0, 0x27DD);

/// For the interrupt, and for whoever looks.
static LINK: Mutex<RefCell<Option<Link>>> = Mutex::new(RefCell::new(None));

struct Link {
    device: UsbDevice<'static, UsbBus>,
    port: Port,
    inbox: &'static mut Inbox,
    timer: Timer,
    /// When a byte came last.
    last: Instant,
}

/// What comes, until it is looked at.
pub(crate) type Inbox = Receiver<ROOM>;

/// With room for the longest answer.
type Port = SerialPort<'static, UsbBus, [u8; 128], [u8; 256]>;

/// Connects to a host whenever there is one; once.
pub(crate) fn start(bus: UsbBus, inbox: &'static mut Inbox, timer: Timer) {
    let new = cortex_m::singleton!(: UsbBusAllocator<UsbBus> = UsbBusAllocator::new(bus));
    let bus = new.expect("the board is taken once");
    let port = SerialPort::new_with_store(bus, [0; 128], [0; 256]);
    let names = StringDescriptors::default()
        .manufacturer("whitted")
        .product("Pico with a display");
    let device = UsbDeviceBuilder::new(bus, VENDOR_PRODUCT)
        .strings(&[names])
        .and_then(|builder| builder.max_packet_size_0(64))
        .expect("names and size are what USB allows")
        .device_class(USB_CLASS_CDC)
        .build();
    let link = Link {
        device,
        port,
        inbox,
        timer,
        last: timer.get_counter(),
    };
    critical_section::with(|cs| LINK.replace(cs, Some(link)));
    // SAFETY: no code relies on this interrupt being masked.
    unsafe { cortex_m::peripheral::NVIC::unmask(pac::Interrupt::USBCTRL_IRQ) }
}

#[interrupt]
fn USBCTRL_IRQ() {
    with_link(Link::poll);
}

/// Whether a scene came that `check` lets pass; the host gets its answer.
pub(crate) fn receive(check: impl FnOnce(&[u8]) -> Result<(), DecodeError>) -> bool {
    with_link(|link| link.look(check)).unwrap_or(false)
}

fn with_link<R>(act: impl FnOnce(&mut Link) -> R) -> Option<R> {
    critical_section::with(|cs| LINK.borrow_ref_mut(cs).as_mut().map(act))
}

impl Link {
    fn poll(&mut self) {
        if !self.device.poll(&mut [&mut self.port]) {
            return;
        }
        let mut packet = [0; 64];
        while let Ok(length) = self.port.read(&mut packet) {
            self.last = self.timer.get_counter();
            for byte in packet.iter().take(length) {
                if let Some(Err(why)) = self.inbox.receive(*byte) {
                    self.answer(Answer::Broken { why });
                }
            }
        }
    }

    fn look(&mut self, check: impl FnOnce(&[u8]) -> Result<(), DecodeError>) -> bool {
        let Some(Message { ticket, scene }) = self.inbox.message() else {
            let silence = self.timer.get_counter() - self.last;
            if silence > PATIENCE
                && let Some(why) = self.inbox.forget()
            {
                self.answer(Answer::Broken { why });
            }
            return false;
        };
        let checked = check(scene);
        self.inbox.forget();
        self.answer(match checked {
            Ok(()) => Answer::Shown { ticket },
            Err(why) => Answer::Refused { ticket, why },
        });
        checked.is_ok()
    }

    /// A host that does not read loses what there is no room for.
    fn answer(&mut self, answer: Answer<impl fmt::Display>) {
        _ = writeln!(Lines(&mut self.port), "{answer}");
    }
}

struct Lines<'p>(&'p mut Port);

impl Write for Lines<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.write(text.as_bytes()).map_err(|_| fmt::Error)?;
        Ok(())
    }
}
