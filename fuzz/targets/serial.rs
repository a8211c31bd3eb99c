#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| {
    whitted_fuzz::serial(input);
});
