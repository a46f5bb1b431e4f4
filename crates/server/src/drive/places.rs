//! Places of the clients of a drive: which connection leaves for a new one.

use std::collections::BTreeMap;
use std::net::SocketAddr;
use std::time::{Duration, Instant};
use tokio::sync::mpsc;

/// Time without a valid request after which a client may be replaced.
const IDLE_TIME: Duration = Duration::from_secs(10);

/// Largest number of connections that have made no request of the protocol yet; a further one replaces the oldest of them,
/// so that silent connections keep no client out.
pub(super) const SILENT_MOST: usize = 64;

/// Largest number of clients that have made a request of the protocol; a further one replaces the longest idle client or is
/// rejected.
pub const CLIENTS_MOST: usize = 8;

/// A client.
pub(super) struct Client {
    pub(super) out: mpsc::Sender<Vec<u8>>,
    /// The first request was one of the protocol: a command, raw mode.
    pub(super) is_known: bool,
    /// Time of its last valid request.
    pub(super) heard: Instant,
    /// Address of the other end.
    pub(super) peer: SocketAddr,
}

/// Returns the connection without a request that leaves for a new one: the oldest. Their users are not looked up, which takes
/// longer than a connection.
pub(super) fn silent_leaving(clients: &BTreeMap<u64, Client>) -> Option<u64> {
    // They are numbered as they come.
    clients.iter().find(|(_, client)| !client.is_known).map(|(id, _)| *id)
}

/// Returns the client that leaves for a new one of the user `new`: the longest idle of those idle for [`IDLE_TIME`] and, for the user
/// who runs the drive, of all others. Otherwise other users share the places: the user with the most of them gives one to a user with
/// at least two fewer. Connections without a request are no clients here.
pub(super) fn leaving(
    clients: &BTreeMap<u64, Client>,
    user_of: impl Fn(SocketAddr) -> Option<u32>,
    new: Option<u32>,
    own: Option<u32>,
) -> Option<u64> {
    let known = || clients.iter().filter(|(_, client)| client.is_known);
    let users: BTreeMap<u64, Option<u32>> = known().map(|(id, client)| (*id, user_of(client.peer))).collect();
    let is_foreign = |id: &u64| users.get(id).is_some_and(|user| user.is_some() && *user != own);
    let places = |user: Option<u32>| users.values().filter(|other| **other == user).count();
    let longest_idle = |leaves: &dyn Fn(&u64, &Client) -> bool| {
        let found = known().filter(|(id, client)| leaves(id, client)).min_by_key(|(_, client)| client.heard);
        found.map(|(id, _)| *id)
    };
    let is_own = new.is_some() && new == own;
    longest_idle(&|id, client| client.heard.elapsed() >= IDLE_TIME || is_own && is_foreign(id)).or_else(|| {
        let most =
            users.iter().filter(|(id, _)| is_foreign(id)).map(|(_, user)| *user).max_by_key(|user| places(*user))?;
        let shares = new.is_some() && places(most) >= places(new) + 2;
        shares.then(|| longest_idle(&|id, _| users.get(id) == Some(&most))).flatten()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::net::Ipv4Addr;

    const OWN: u32 = 1000;

    fn peer(port: u16) -> SocketAddr {
        SocketAddr::from((Ipv4Addr::LOCALHOST, port))
    }

    /// Returns clients of these users, the port of each its user, and how long each has been idle.
    fn clients(users: &[(u16, Duration)]) -> BTreeMap<u64, Client> {
        let now = Instant::now();
        let client = |(user, idle): &(u16, Duration)| {
            let heard = now.checked_sub(*idle).unwrap_or(now);
            Client { out: mpsc::channel(1).0, is_known: true, heard, peer: peer(*user) }
        };
        (1..).zip(users.iter().map(client)).collect()
    }

    fn leaves(clients: &BTreeMap<u64, Client>, new: u32) -> Option<u64> {
        leaving(clients, |peer| Some(u32::from(peer.port())), Some(new), Some(OWN))
    }

    /// Clients of another user that are never idle do not keep the user of the drive out.
    #[test]
    fn clients_of_another_user_leave_for_those_of_the_user() {
        let busy = clients(&[(1000, 4), (1000, 3), (1000, 3), (7, 2), (7, 3), (8, 1), (8, 0), (8, 0)].map(idle));
        assert_eq!(leaves(&busy, OWN), Some(5), "the longest idle of the others");
        let all_own = clients(&[(1000, 4); 8].map(idle));
        assert_eq!(leaves(&all_own, OWN), None, "clients of one user do not replace each other");
        assert_eq!(leaves(&all_own, 7), None, "those of the user who runs the drive stay");
        let unknown = |new| leaving(&busy, |_| None, new, Some(OWN));
        assert_eq!([unknown(Some(OWN)), unknown(None)], [None, None], "where the users are unknown");
    }

    /// A client that has sent no valid request for ten seconds leaves for any other.
    #[test]
    fn an_idle_client_leaves_for_any_other() {
        let one_idle = clients(&[(1000, 9), (1000, 11), (7, 12), (7, 1), (7, 1), (7, 1), (7, 1), (7, 1)].map(idle));
        for new in [OWN, 7, 8] {
            assert_eq!(leaves(&one_idle, new), Some(3), "{new}");
        }
        assert_eq!(leaving(&one_idle, |_| None, None, None), Some(3));
    }

    /// Other users take places from each other until each has the same number, and none back: whatever comes in whatever order, no user
    /// is kept out, and no place is taken that would have to be given back.
    #[test]
    fn other_users_share_the_places() {
        let mut busy = clients(&[(7, 1); 8].map(idle));
        let mut next = 9;
        let mut come = |user: u16| {
            let Some(id) = leaves(&busy, user.into()) else { return false };
            busy.remove(&id);
            busy.extend(clients(&[(user, Duration::ZERO)]).into_values().map(|client| (next, client)));
            next += 1;
            true
        };
        assert_eq!([8; 5].map(&mut come), [true, true, true, true, false], "four each");
        assert!(!come(7), "a user does not take back what was shared");
        assert_eq!([9; 3].map(&mut come), [true, true, false], "3, 3 and 2");
        let held = |user| busy.values().filter(|client| client.peer.port() == user).count();
        assert_eq!([7, 8, 9].map(held), [3, 3, 2]);
    }

    /// Silent connections are no clients, and leave oldest first.
    #[test]
    fn silent_connections_take_no_place() {
        let mut all = clients(&[(1000, 60), (7, 50), (7, 40)].map(idle));
        all.values_mut().for_each(|client| client.is_known = false);
        assert_eq!((leaves(&all, OWN), silent_leaving(&all)), (None, Some(1)));
        all.get_mut(&1).unwrap().is_known = true;
        assert_eq!(silent_leaving(&all), Some(2));
        all.values_mut().for_each(|client| client.is_known = true);
        assert_eq!(silent_leaving(&all), None);
    }

    fn idle((user, seconds): (u16, u64)) -> (u16, Duration) {
        (user, Duration::from_secs(seconds))
    }
}
