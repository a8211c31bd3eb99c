use scene_serial::{Answer, Message, Receiver, frame, frame_len};

/// Largest scene, in bytes.
const MAX_LEN: usize = 58;
/// Receiver capacity: scene, ticket and checksum.
const CAPACITY: usize = MAX_LEN + 6;

/// Checks the receiver with any bytes on the serial line.
///
/// A received message must survive another transfer, and a message must arrive after any
/// other bytes. Returns true if the input contains a message.
pub fn serial(input: &[u8]) -> bool {
    let mut receiver = Receiver::<CAPACITY>::new();
    let mut has_message = false;
    for byte in input {
        match receiver.receive(*byte) {
            None => {}
            Some(Err(error)) => assert!(!error.to_string().is_empty()),
            Some(Ok(())) => {
                let message = receiver.message().expect("`receive` reported a message");
                assert_arrives(&mut Receiver::new(), message);
                has_message = true;
                assert_eq!(receiver.forget(), None);
            }
        }
    }
    let scene = &input[..input.len().min(MAX_LEN)];
    let ticket = input.len() as u16;
    assert_arrives(&mut receiver, Message { ticket, scene });
    if let Some(answer) = core::str::from_utf8(input).ok().and_then(Answer::parse) {
        assert_eq!(Answer::parse(&answer.to_string()), Some(answer));
    }
    has_message
}

/// Sends a message and checks that it arrives.
fn assert_arrives(receiver: &mut Receiver<CAPACITY>, message: Message<'_>) {
    let mut buffer = [0; frame_len(MAX_LEN)];
    let frame = frame(message.ticket, message.scene, &mut buffer)
        .expect("the buffer has `frame_len` bytes");
    let (start, rest) = frame.split_first().expect("a frame begins with a zero");
    // The first zero may complete an earlier frame of the input.
    if let Some(Ok(())) = receiver.receive(*start) {
        receiver.forget();
    }
    let results: Vec<_> = rest
        .iter()
        .filter_map(|byte| receiver.receive(*byte))
        .collect();
    assert_eq!(results, [Ok(())]);
    assert_eq!(receiver.message(), Some(message));
}
