//! Firmware in QEMU, compared with the simulator on the host.

mod cores;
mod oled;
