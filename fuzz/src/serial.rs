use scene_serial::{Answer, Message, Receiver, frame, frame_len};

/// Bytes of a scene that there is room for.
const SCENE: usize = 58;
const ROOM: usize = SCENE + 6;

/// Of any bytes on a serial line, what arrives as a message is one when it is sent
/// again; and after any bytes a message arrives. Says whether one was in them.
pub fn serial(input: &[u8]) -> bool {
    let mut receiver = Receiver::<ROOM>::new();
    let mut has_arrived = false;
    for byte in input {
        match receiver.receive(*byte) {
            None => {}
            Some(Err(error)) => assert!(!error.to_string().is_empty()),
            Some(Ok(())) => {
                let message = receiver.message().expect("it was received");
                arrives(&mut Receiver::new(), message);
                has_arrived = true;
                assert_eq!(receiver.forget(), None);
            }
        }
    }
    let scene = &input[..input.len().min(SCENE)];
    let ticket = input.len() as u16;
    arrives(&mut receiver, Message { ticket, scene });
    if let Some(answer) = core::str::from_utf8(input).ok().and_then(Answer::parse) {
        assert_eq!(Answer::parse(&answer.to_string()), Some(answer));
    }
    has_arrived
}

fn arrives(receiver: &mut Receiver<ROOM>, message: Message<'_>) {
    let mut room = [0; frame_len(SCENE)];
    let frame = frame(message.ticket, message.scene, &mut room).expect("there is room");
    let (start, rest) = frame.split_first().expect("it begins with a zero");
    // What came before may end with it.
    if let Some(Ok(())) = receiver.receive(*start) {
        receiver.forget();
    }
    let ends: Vec<_> = rest.iter().filter_map(|it| receiver.receive(*it)).collect();
    assert_eq!(ends, [Ok(())]);
    assert_eq!(receiver.message(), Some(message));
}
