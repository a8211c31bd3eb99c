//! Frames that arrive, and frames that do not.

#![allow(clippy::unwrap_used)]

use fastrand::Rng;
use scene_serial::{Answer, Broken, Message, Receiver, frame, frame_len};

/// Room for 300 bytes of a scene.
const ROOM: usize = 306;
const MOST: usize = 300;

const TICKET: u16 = 0xA05F;

fn framed(scene: &[u8]) -> Vec<u8> {
    let mut room = vec![0xEE; frame_len(scene.len())];
    frame(TICKET, scene, &mut room).unwrap().to_vec()
}

/// What came to its end while these bytes were received.
fn received(receiver: &mut Receiver<ROOM>, bytes: &[u8]) -> Vec<Result<(), Broken>> {
    bytes
        .iter()
        .filter_map(|byte| receiver.receive(*byte))
        .collect()
}

/// A scene of random bytes, many of which are zero.
fn random_scene(random: &mut Rng, length: usize) -> Vec<u8> {
    let mut byte = || random.u8(..) & random.u8(..) & random.u8(..);
    (0..length).map(|_| byte()).collect()
}

fn assert_arrives(receiver: &mut Receiver<ROOM>, scene: &[u8]) {
    assert_eq!(received(receiver, &framed(scene)), [Ok(())]);
    let ticket = TICKET;
    assert_eq!(receiver.message(), Some(Message { ticket, scene }));
    // It is no part of anything.
    assert_eq!(receiver.forget(), None);
    assert_eq!(receiver.message(), None);
}

#[test]
fn scenes_of_every_length_arrive() {
    let mut random = Rng::with_seed(1);
    let mut receiver = Receiver::new();
    for length in 0..=MOST {
        assert_arrives(&mut receiver, &random_scene(&mut random, length));
        assert_arrives(&mut receiver, &vec![0; length]);
        assert_arrives(&mut receiver, &vec![0xFF; length]);
    }
}

#[test]
fn no_flipped_bit_arrives_and_the_next_frame_does() {
    let mut random = Rng::with_seed(2);
    let scene = random_scene(&mut random, MOST);
    let whole = framed(&scene);
    for bit in 0..8 * whole.len() {
        let mut receiver = Receiver::new();
        let mut flipped = whole.clone();
        flipped[bit / 8] ^= 1 << (bit % 8);
        let outcomes = received(&mut receiver, &flipped);
        // A first zero that is none starts a frame of its own, of one byte too many.
        assert!(!outcomes.contains(&Ok(())), "bit {bit}");
        assert_eq!(receiver.message(), None, "bit {bit}");
        let after = received(&mut receiver, &whole);
        assert_eq!(after.last(), Some(&Ok(())), "bit {bit}");
    }
}

#[test]
fn nothing_that_is_cut_arrives_and_the_next_frame_does() {
    // But for its last zero, in whose place is the first of the next.
    let scene = random_scene(&mut Rng::with_seed(3), 40);
    let whole = framed(&scene);
    for length in 0..whole.len() - 1 {
        let mut receiver = Receiver::new();
        assert_eq!(received(&mut receiver, &whole[..length]), []);
        assert_eq!(receiver.message(), None);
        let after = received(&mut receiver, &whole);
        let broken = (length > 1).then_some(Err(Broken::Damaged));
        let expected: Vec<_> = broken.into_iter().chain([Ok(())]).collect();
        assert_eq!(after, expected, "{length} bytes");
        assert_eq!(
            receiver.message().map(|message| message.scene),
            Some(&*scene)
        );
    }
}

#[test]
fn what_does_not_go_on_is_forgotten() {
    let scene = random_scene(&mut Rng::with_seed(4), 40);
    let whole = framed(&scene);
    let mut receiver = Receiver::new();
    assert_eq!(receiver.forget(), None);
    for length in 2..whole.len() {
        assert_eq!(received(&mut receiver, &whole[..length]), []);
        assert_eq!(receiver.forget(), Some(Broken::Stalled));
        assert_eq!(receiver.forget(), None);
        assert_arrives(&mut receiver, &scene);
    }
}

#[test]
fn one_byte_too_many_is_too_long() {
    let mut random = Rng::with_seed(5);
    let mut receiver = Receiver::new();
    let fits = random_scene(&mut random, MOST);
    for length in [MOST + 1, 10 * MOST] {
        let scene = random_scene(&mut random, length);
        let too_long = Err(Broken::TooLong { most: MOST });
        assert_eq!(received(&mut receiver, &framed(&scene)), [too_long]);
        assert_eq!(receiver.message(), None);
        assert_arrives(&mut receiver, &fits);
    }
}

#[test]
fn whatever_arrives_the_next_frame_does() {
    let mut random = Rng::with_seed(6);
    let mut receiver = Receiver::new();
    let scene = random_scene(&mut random, 100);
    for _ in 0..2000 {
        let length = random.usize(..3 * ROOM);
        let garbage = random_scene(&mut random, length);
        assert!(!received(&mut receiver, &garbage).contains(&Ok(())));
        let after = received(&mut receiver, &framed(&scene));
        assert_eq!(after.last(), Some(&Ok(())));
        assert_eq!(
            receiver.message().map(|message| message.scene),
            Some(&*scene)
        );
        receiver.forget();
    }
}

#[test]
fn a_message_stays_until_it_is_forgotten() {
    let scene = random_scene(&mut Rng::with_seed(7), 40);
    let mut receiver = Receiver::new();
    assert_eq!(received(&mut receiver, &framed(&scene)), [Ok(())]);
    assert_eq!(received(&mut receiver, &framed(b"other")), []);
    let ticket = TICKET;
    let scene = &*scene;
    assert_eq!(receiver.message(), Some(Message { ticket, scene }));
    receiver.forget();
    assert_arrives(&mut receiver, b"other");
}

#[test]
fn a_frame_needs_its_room() {
    for length in [0, 1, 247, 248, 249, 1000] {
        let scene = vec![7; length];
        let mut room = vec![0; frame_len(length)];
        assert!(frame(TICKET, &scene, &mut room).is_some());
        assert_eq!(frame(TICKET, &scene, &mut room[1..]), None);
    }
}

#[test]
fn answers_are_read_as_they_are_written() {
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
