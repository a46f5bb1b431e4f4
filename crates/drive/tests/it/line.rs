//! The line protocol.

use super::usual;
use drive::line::{Answer, Time, WRONG, answer};

#[test]
fn lines_are_answered() {
    let axis = usual();
    let mut drive = axis.drive();
    let mut ask = |line: &str| answer(&mut drive, Time::Stepped, line);
    let line = |text: &str| if text == WRONG { Answer::Wrong } else { Answer::Line(text.to_owned()) };
    for (asked, expected) in [
        ("read 6041", "ok 592"),
        ("read 1018:2", "ok 1026"),
        ("read 1008", "ok \"antrieb CHA-25A-100-H-M512P-B\""),
        ("read 9999", "abort 0x06020000"),
        ("read 6091:9", "abort 0x06090011"),
        ("write 6040 6", "ok"),
        ("read 6041", "ok 561"),
        ("write 6040 0x07", "ok"),
        ("write 6041 1", "abort 0x06010002"),
        ("write 6060 2", "abort 0x06090030"),
        ("write 607A -5", "ok"),
        ("step 10", "ok 11.0"),
        ("step 0.5", "ok 11.5"),
        ("time", "ok 11.5 stepped"),
        ("step 0.3", "error arguments"),
        ("step -1", "error arguments"),
        ("step inf", "error arguments"),
        ("step 10001", "error arguments"),
        ("read", "error arguments"),
        ("read +6041", "error arguments"),
        ("write 6040 x", "error arguments"),
        ("bye now", "error arguments"),
    ] {
        assert_eq!(ask(asked), line(expected), "{asked}");
    }
    assert_eq!(ask("bye"), Answer::Bye);
    assert_eq!(ask("GET / HTTP/1.1"), Answer::NoCommand);
    let Answer::Line(status) = ask("status") else { panic!() };
    assert_eq!(
        status.split(" link=").next().unwrap(),
        "ok time=11.5 state=switched_on statusword=0x0233 error=0x0000 mode=0 demand=0 position=0 velocity=0 following=0 current=0"
    );
    assert_eq!(answer(&mut drive, Time::Real, "step 1"), line("error real_time"));
}
