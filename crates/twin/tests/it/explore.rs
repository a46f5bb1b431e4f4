use super::*;
use twin::*;

#[test]
fn explore() {
    let p = parameters("CHA-20A-100-H-C1024");
    let mech = load(1.3, 5.0);
    let motion = one_move(30.0, 0.1, 0.3, 0.5);
    let extras = NOTHING();
    let setup = Setup { scenario: Scenario { cycles: 1, ..Scenario::default() }, ..Setup::of(&p, &mech, &motion, &extras) };
    let mut t = Twin::new(&setup).unwrap();
    println!("{:?}", t.gains());
    println!("{:?}", t.limits());
    for l in LoopResponse::of(&setup).unwrap() { println!("{:?} {:?}", l.of, l.margins); }
    while !t.is_over() { t.advance(320); let s = t.sample(); println!("{:.3} w {:.4} v {:.4} vl {:.4} T {:.2} iq {:.3} foll {:.3e} link {:.1}", s.time_s, s.wanted_rad_s, s.motor_rad_s, s.speed_rad_s, s.torque_nm, s.current_q_a, s.following_rad, s.link_v); }
    println!("{:#?}", t.summary());
    println!("{:#?}", t.events());
    let t0 = std::time::Instant::now();
    let mut t = Twin::new(&Setup { scenario: Scenario { cycles: 20, ..Scenario::default() }, ..setup }).unwrap();
    t.advance(u64::MAX);
    println!("{} x, unaccounted {:e} of {:e}", t.time_s() / t0.elapsed().as_secs_f64(), t.summary().unaccounted_j, t.summary().throughput_j);
}
