use std::collections::HashMap;
use std::io::{BufRead, BufReader};
use std::process::{Child, Command, Stdio};

use anyhow::{Context, Result, bail};

/// From the address of an instruction to that of the next one.
pub(crate) type Step = (u64, u64);

/// How often each step was taken before `end` was reached, by a QEMU that runs
/// this.
pub(crate) fn executed(mut qemu: Command, end: u64) -> Result<HashMap<Step, u64>> {
    // Blocks of one instruction, each logged each time. QEMU since 9.0 calls the
    // first `-accel tcg,one-insn-per-tb=on`. Its own log goes to stderr, too,
    // but a character at a time.
    qemu.args(["-singlestep", "-d", "exec,nochain", "-D", "/dev/stderr"]);
    qemu.stdin(Stdio::null()).stdout(Stdio::null());
    let mut running = Killed(qemu.stderr(Stdio::piped()).spawn()?);
    let mut log = BufReader::new(running.0.stderr.take().context("stderr is a pipe")?);

    let mut counts = HashMap::new();
    let mut last = None;
    let mut line = Vec::new();
    loop {
        line.clear();
        if log.read_until(b'\n', &mut line)? == 0 {
            bail!("the firmware does not draw: {}", running.0.wait()?);
        }
        let Some(address) = address(&line) else {
            continue;
        };
        if let Some(last) = last.replace(address) {
            *counts.entry((last, address)).or_default() += 1;
        }
        if address == end {
            return Ok(counts);
        }
    }
}

/// A QEMU that nobody needs any more once this is gone.
struct Killed(Child);

impl Drop for Killed {
    fn drop(&mut self) {
        _ = self.0.kill();
        _ = self.0.wait();
    }
}

/// The program counter in `Trace 0: 0x7f0123456789 [00000000/00001234/...`.
fn address(line: &[u8]) -> Option<u64> {
    let line = line.strip_prefix(b"Trace")?;
    let address = std::str::from_utf8(line).ok()?.split('/').nth(1)?;
    u64::from_str_radix(address, 16).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_address_is_read() {
        let line = b"Trace 0: 0x7f8c24000100 [00000000/00001a2c/00000110/ff001201] main\n";
        assert_eq!(address(line), Some(0x1a2c));
        assert_eq!(address(b"Linking TBs\n"), None);
    }
}
