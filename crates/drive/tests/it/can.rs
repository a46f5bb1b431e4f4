//! The node of CANopen: SDO, NMT, PDO, SYNC, heartbeat, EMCY. Bytes are typed from CiA 301.

use super::usual;
use drive::State;
use drive::can::{CanNode, Frame, Nmt};
use drive::socketcand::{self, Message};

fn node(axis: &super::Axis, steps_with_sync: bool) -> CanNode<'_> {
    let mut node = CanNode::new(axis.drive(), 1, steps_with_sync);
    assert_eq!(node.take(), [Frame::new(0x701, &[0])], "boot-up");
    node
}

fn sdo(node: &mut CanNode<'_>, request: [u8; 8]) -> Vec<u8> {
    node.receive(&Frame::new(0x601, &request));
    let answers = node.take();
    let [answer] = answers.as_slice() else { panic!("{answers:?}") };
    assert_eq!(answer.id(), 0x581);
    answer.data().to_vec()
}

#[test]
fn sdo_reads_writes_and_aborts() {
    let axis = usual();
    let mut node = node(&axis, false);
    let of = |request| sdo(&mut node, request);
    let mut of = of;
    // Device type 0x00020192; statusword in two bytes; supported modes.
    assert_eq!(of([0x40, 0x00, 0x10, 0, 0, 0, 0, 0]), [0x43, 0x00, 0x10, 0, 0x92, 0x01, 0x02, 0x00]);
    assert_eq!(of([0x40, 0x41, 0x60, 0, 0, 0, 0, 0]), [0x4B, 0x41, 0x60, 0, 0x50, 0x02, 0, 0]);
    assert_eq!(of([0x2B, 0x40, 0x60, 0, 0x06, 0, 0, 0]), [0x60, 0x40, 0x60, 0, 0, 0, 0, 0]);
    // A size that is not stated is that of the type.
    assert_eq!(of([0x22, 0x40, 0x60, 0, 0x07, 0, 0, 0]), [0x60, 0x40, 0x60, 0, 0, 0, 0, 0]);
    let abort = |answer: Vec<u8>| u32::from_le_bytes(answer[4..].try_into().unwrap());
    assert_eq!(abort(of([0x40, 0x99, 0x60, 0, 0, 0, 0, 0])), 0x0602_0000);
    assert_eq!(abort(of([0x40, 0x91, 0x60, 9, 0, 0, 0, 0])), 0x0609_0011);
    assert_eq!(abort(of([0x2F, 0x40, 0x60, 0, 6, 0, 0, 0])), 0x0607_0013, "a byte for a word");
    assert_eq!(abort(of([0x23, 0x40, 0x60, 0, 6, 0, 0, 0])), 0x0607_0012, "a double word");
    assert_eq!(abort(of([0x2B, 0x41, 0x60, 0, 6, 0, 0, 0])), 0x0601_0002);
    assert_eq!(abort(of([0x2F, 0x60, 0x60, 0, 9, 0, 0, 0])), 0x0609_0030);
    assert_eq!(abort(of([0xA0, 0x40, 0x60, 0, 0, 0, 0, 0])), 0x0504_0001, "block transfer");
    assert_eq!(abort(of([0x21, 0x40, 0x60, 0, 2, 0, 0, 0])), 0x0504_0001, "segments");
}

#[test]
fn a_text_is_read_in_segments() {
    let axis = usual();
    let mut node = node(&axis, false);
    let head = sdo(&mut node, [0x40, 0x08, 0x10, 0, 0, 0, 0, 0]);
    assert_eq!(head, [0x41, 0x08, 0x10, 0, 29, 0, 0, 0]);
    let mut text: Vec<u8> = Vec::new();
    for toggle in [0, 0x10, 0, 0x10, 0] {
        let part = sdo(&mut node, [0x60 | toggle, 0, 0, 0, 0, 0, 0, 0]);
        assert_eq!(part[0] & 0x10, toggle);
        text.extend(&part[1..8 - usize::from(part[0] >> 1 & 7)]);
        assert_eq!(part[0] & 1 == 1, text.len() == 29);
    }
    assert_eq!(text, b"antrieb CHA-25A-100-H-M512P-B");
    let wrong = sdo(&mut node, [0x60, 0, 0, 0, 0, 0, 0, 0]);
    assert_eq!(wrong[0], 0x80);
}

#[test]
fn pdos_follow_the_network_management() {
    let axis = usual();
    let mut node = node(&axis, false);
    let control = |word: u8| Frame::new(0x201, &[word, 0]);
    node.receive(&control(0x06));
    assert_eq!(node.drive().state(), State::SwitchOnDisabled, "not operational");
    node.receive(&Frame::new(0, &[1, 1]));
    assert_eq!((node.nmt(), node.take()), (Nmt::Operational, vec![Frame::new(0x181, &[0x50, 0x02])]));
    for (word, status) in [(0x06, 0x31), (0x07, 0x33), (0x0F, 0x37)] {
        node.receive(&control(word));
        node.advance(2);
        assert_eq!(node.take(), [Frame::new(0x181, &[status, 0x02])], "sent on a change");
    }
    node.advance(20);
    assert_eq!(node.take(), [], "and not again");
    // Short: emergency 0x8210. Another node's command is not ours.
    node.receive(&Frame::new(0x201, &[0x06]));
    assert_eq!(node.take(), [Frame::new(0x081, &[0x10, 0x82, 0x11, 0, 0, 0, 0, 0])]);
    node.receive(&Frame::new(0, &[2, 5]));
    assert_eq!(node.nmt(), Nmt::Operational);
    node.receive(&Frame::new(0, &[2, 0]));
    node.receive(&Frame::new(0x601, &[0x40, 0, 0x10, 0, 0, 0, 0, 0]));
    assert_eq!((node.nmt(), node.take()), (Nmt::Stopped, vec![]));
}

#[test]
fn heartbeat_emergency_and_reset() {
    let axis = usual();
    let mut node = node(&axis, false);
    sdo(&mut node, [0x2B, 0x17, 0x10, 0, 50, 0, 0, 0]);
    node.advance(200);
    assert_eq!(node.take(), [Frame::new(0x701, &[127]); 2]);
    // No signal of the encoder: 0x7305, register 0x21.
    sdo(&mut node, [0x2F, 0x10, 0x20, 0, 3, 0, 0, 0]);
    node.advance(20);
    assert!(node.take().contains(&Frame::new(0x081, &[0x05, 0x73, 0x21, 0, 0, 0, 0, 0])));
    assert_eq!(node.drive().state(), State::Fault);
    node.receive(&Frame::new(0, &[129, 1]));
    assert_eq!(node.take(), [Frame::new(0x701, &[0])]);
    node.advance(10);
    assert_eq!(
        (node.drive().state(), node.take()),
        (State::SwitchOnDisabled, vec![]),
        "its values are those of the start"
    );
}

/// The controller's heartbeat of node 5 every 20 ms: once it stops, the drive has fault 0x8130.
#[test]
fn a_silent_controller_is_a_fault() {
    let axis = usual();
    let mut node = node(&axis, false);
    sdo(&mut node, [0x23, 0x16, 0x10, 1, 20, 0, 5, 0]);
    node.advance(200);
    assert_eq!(node.drive().state(), State::SwitchOnDisabled, "not heard yet");
    for _ in 0..5 {
        node.receive(&Frame::new(0x705, &[5]));
        node.advance(30);
    }
    assert_eq!(node.drive().state(), State::SwitchOnDisabled);
    node.advance(20);
    assert!(node.take().contains(&Frame::new(0x081, &[0x30, 0x81, 0x11, 0, 0, 0, 0, 0])));
    assert_eq!(node.drive().state(), State::Fault);
}

/// Type 1: received set-points are taken, and actual values sent, with the SYNC message, which makes the time go on.
#[test]
fn sync_takes_sends_and_steps() {
    let axis = usual();
    let mut node = node(&axis, true);
    for (index, sub, size, value) in [(0x1400_u16, 2_u8, 1, 1_u32), (0x1800, 2, 1, 1), (0x60C2, 1, 1, 4)] {
        let [low, high] = index.to_le_bytes();
        let head = 0x23 | (4 - size) << 2;
        let [a, b, c, d] = value.to_le_bytes();
        assert_eq!(sdo(&mut node, [head, low, high, sub, a, b, c, d])[0], 0x60);
    }
    node.receive(&Frame::new(0, &[1, 0]));
    assert_eq!(node.take(), []);
    node.receive(&Frame::new(0x201, &[0x06, 0]));
    assert_eq!(node.drive().state(), State::SwitchOnDisabled, "it waits");
    let before = node.drive().ticks();
    node.receive(&Frame::new(0x080, &[]));
    assert_eq!(node.drive().state(), State::ReadyToSwitchOn);
    assert_eq!(node.take(), [Frame::new(0x181, &[0x31, 0x02])]);
    assert_eq!(node.drive().ticks() - before, 8, "4 ms of 60C2h");
}

#[test]
fn the_messages_of_socketcand_are_read_and_written() {
    let send = socketcand::read(b" < send 601 8 40 0 10 0 0 0 0 ff >< echo >");
    assert_eq!(send, Ok(Some((Message::Send(Frame::new(0x601, &[0x40, 0, 0x10, 0, 0, 0, 0, 0xFF])), 34))));
    for (text, message) in [
        ("< open can0 >", Message::Open),
        ("< rawmode >", Message::RawMode),
        ("< send 080 0  >", Message::Send(Frame::new(0x80, &[]))),
        ("< send 00000601 0 >", Message::Other),
        ("< bcmmode >", Message::Other),
    ] {
        assert_eq!(socketcand::read(text.as_bytes()), Ok(Some((message, text.len()))), "{text}");
    }
    assert_eq!(socketcand::read(b"< send 601 8 40"), Ok(None));
    for text in
        ["GET / HTTP/1.1", "< >", "< send >", "< send 601 9 0 0 0 0 0 0 0 0 0 >", "< send 601 2 40 >", "< send x 0 >"]
    {
        assert_eq!(socketcand::read(text.as_bytes()), Err(socketcand::NoMessage), "{text}");
    }
    assert_eq!(socketcand::read(&[b'<'; 300]), Err(socketcand::NoMessage));
    let frame = Frame::new(0x581, &[0x43, 0, 0x10]);
    assert_eq!(socketcand::written(&frame, 1.5), "< frame 581 1.500000 430010 >");
    assert_eq!(socketcand::sent(&frame), "< send 581 3 43 0 10 >");
}
