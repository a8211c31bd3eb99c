//! Tests transfers that are intact, damaged, incomplete or too long.

#![allow(clippy::unwrap_used)]

use fastrand::Rng;
use scene_serial::{Answer, Message, ReceiveError, Receiver, frame, frame_len};

/// Buffer size in bytes: a scene of `MAX_LEN` bytes, plus 6 bytes for ticket and checksum.
const CAPACITY: usize = MAX_LEN + 6;
const MAX_LEN: usize = 300;

const TICKET: u16 = 0xA05F;

fn encode_frame(scene: &[u8]) -> Vec<u8> {
    let mut buffer = vec![0xEE; frame_len(scene.len())];
    frame(TICKET, scene, &mut buffer).unwrap().to_vec()
}

/// Feeds bytes to the receiver and returns the result of each frame that ended.
fn receive_all(receiver: &mut Receiver<CAPACITY>, bytes: &[u8]) -> Vec<Result<(), ReceiveError>> {
    bytes
        .iter()
        .filter_map(|byte| receiver.receive(*byte))
        .collect()
}

/// Returns random bytes, about a third of which are zero.
fn random_scene(random: &mut Rng, length: usize) -> Vec<u8> {
    let mut byte = || random.u8(..) & random.u8(..) & random.u8(..);
    (0..length).map(|_| byte()).collect()
}

fn assert_arrives(receiver: &mut Receiver<CAPACITY>, scene: &[u8]) {
    assert_eq!(receive_all(receiver, &encode_frame(scene)), [Ok(())]);
    let ticket = TICKET;
    assert_eq!(receiver.message(), Some(Message { ticket, scene }));
    // After a complete message, `forget` reports no incomplete frame.
    assert_eq!(receiver.forget(), None);
    assert_eq!(receiver.message(), None);
}

#[test]
fn receives_scenes_of_every_length() {
    let mut random = Rng::with_seed(1);
    let mut receiver = Receiver::new();
    for length in 0..=MAX_LEN {
        assert_arrives(&mut receiver, &random_scene(&mut random, length));
        assert_arrives(&mut receiver, &vec![0; length]);
        assert_arrives(&mut receiver, &vec![0xFF; length]);
    }
}

#[test]
fn detects_every_flipped_bit_and_receives_the_next_frame() {
    let mut random = Rng::with_seed(2);
    let scene = random_scene(&mut random, MAX_LEN);
    let whole = encode_frame(&scene);
    for bit in 0..8 * whole.len() {
        let mut receiver = Receiver::new();
        let mut flipped = whole.clone();
        flipped[bit / 8] ^= 1 << (bit % 8);
        let outcomes = receive_all(&mut receiver, &flipped);
        // A flipped bit may also start or end a frame early.
        assert!(!outcomes.contains(&Ok(())), "bit {bit}");
        assert_eq!(receiver.message(), None, "bit {bit}");
        let after = receive_all(&mut receiver, &whole);
        assert_eq!(after.last(), Some(&Ok(())), "bit {bit}");
    }
}

#[test]
fn detects_truncated_frames_and_receives_the_next_frame() {
    // A frame that lacks only its final zero does not count as truncated: the first zero of
    // the next frame ends it.
    let scene = random_scene(&mut Rng::with_seed(3), 40);
    let whole = encode_frame(&scene);
    for length in 0..whole.len() - 1 {
        let mut receiver = Receiver::new();
        assert_eq!(receive_all(&mut receiver, &whole[..length]), []);
        assert_eq!(receiver.message(), None);
        let after = receive_all(&mut receiver, &whole);
        let error = (length > 1).then_some(Err(ReceiveError::Damaged));
        let expected: Vec<_> = error.into_iter().chain([Ok(())]).collect();
        assert_eq!(after, expected, "{length} bytes");
        assert_eq!(
            receiver.message().map(|message| message.scene),
            Some(&*scene)
        );
    }
}

#[test]
fn forget_discards_incomplete_frames() {
    let scene = random_scene(&mut Rng::with_seed(4), 40);
    let whole = encode_frame(&scene);
    let mut receiver = Receiver::new();
    assert_eq!(receiver.forget(), None);
    for length in 2..whole.len() {
        assert_eq!(receive_all(&mut receiver, &whole[..length]), []);
        assert_eq!(receiver.forget(), Some(ReceiveError::Stalled));
        assert_eq!(receiver.forget(), None);
        assert_arrives(&mut receiver, &scene);
    }
}

#[test]
fn rejects_scenes_that_exceed_the_capacity() {
    let mut random = Rng::with_seed(5);
    let mut receiver = Receiver::new();
    let fits = random_scene(&mut random, MAX_LEN);
    for length in [MAX_LEN + 1, 10 * MAX_LEN] {
        let scene = random_scene(&mut random, length);
        let too_long = Err(ReceiveError::TooLong { max_len: MAX_LEN });
        assert_eq!(
            receive_all(&mut receiver, &encode_frame(&scene)),
            [too_long]
        );
        assert_eq!(receiver.message(), None);
        assert_arrives(&mut receiver, &fits);
    }
}

#[test]
fn receives_a_frame_after_random_bytes() {
    let mut random = Rng::with_seed(6);
    let mut receiver = Receiver::new();
    let scene = random_scene(&mut random, 100);
    for _ in 0..2000 {
        let length = random.usize(..3 * CAPACITY);
        let garbage = random_scene(&mut random, length);
        assert!(!receive_all(&mut receiver, &garbage).contains(&Ok(())));
        let after = receive_all(&mut receiver, &encode_frame(&scene));
        assert_eq!(after.last(), Some(&Ok(())));
        assert_eq!(
            receiver.message().map(|message| message.scene),
            Some(&*scene)
        );
        receiver.forget();
    }
}

#[test]
fn keeps_the_message_until_forget_is_called() {
    let scene = random_scene(&mut Rng::with_seed(7), 40);
    let mut receiver = Receiver::new();
    assert_eq!(receive_all(&mut receiver, &encode_frame(&scene)), [Ok(())]);
    assert_eq!(receive_all(&mut receiver, &encode_frame(b"other")), []);
    let ticket = TICKET;
    let scene = &*scene;
    assert_eq!(receiver.message(), Some(Message { ticket, scene }));
    receiver.forget();
    assert_arrives(&mut receiver, b"other");
}

#[test]
fn encoding_fails_if_the_buffer_is_too_short() {
    for length in [0, 1, 247, 248, 249, 1000] {
        let scene = vec![7; length];
        let mut buffer = vec![0; frame_len(length)];
        assert!(frame(TICKET, &scene, &mut buffer).is_some());
        assert_eq!(frame(TICKET, &scene, &mut buffer[1..]), None);
    }
}

#[test]
fn answers_parse_as_they_were_formatted() {
    let answers = [
        (Answer::Shown { ticket: 7 }, "shown 0007"),
        (
            Answer::Refused {
                ticket: 0xBEEF,
                why: "object 3: no",
            },
            "refused beef: object 3: no",
        ),
        (Answer::Broken { why: "cut" }, "broken: cut"),
    ];
    for (answer, line) in answers {
        assert_eq!(answer.to_string(), line);
        assert_eq!(Answer::parse(line), Some(answer));
    }
    for line in [
        "",
        "shown",
        "shown x",
        "shown 7: why",
        "refused 7",
        "broken",
        "hello: 7",
        "shown 12345",
    ] {
        assert_eq!(Answer::parse(line), None, "{line}");
    }
}
