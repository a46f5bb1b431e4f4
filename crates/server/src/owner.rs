//! Users to whom connections on this machine belong.

use std::net::{IpAddr, SocketAddr};

/// Users of the connections on this machine, as far as the system reports them: only Linux does, here for IPv4.
pub(crate) struct Owners {
    /// Table of the kernel.
    table: String,
    own: Option<u32>,
}

impl Owners {
    /// Reads the users of all connections.
    pub(crate) fn read() -> Self {
        Self { table: std::fs::read_to_string("/proc/net/tcp").unwrap_or_default(), own: of_this_program() }
    }

    /// Returns the user who opened a connection, by the address of its other end; `None` if the system does not report the user.
    pub(crate) fn user_of(&self, peer: SocketAddr) -> Option<u32> {
        of_table(&self.table, peer)
    }

    /// Returns the user who runs this program.
    pub(crate) const fn own(&self) -> Option<u32> {
        self.own
    }
}

#[cfg(target_os = "linux")]
fn of_this_program() -> Option<u32> {
    use std::os::unix::fs::MetadataExt;
    std::fs::metadata("/proc/self").ok().map(|about| about.uid())
}

#[cfg(not(target_os = "linux"))]
const fn of_this_program() -> Option<u32> {
    None
}

/// Returns the user of the socket with a local address in the table of the kernel: a line for each socket, its local address in
/// the second column in the byte order of the machine, its user in the eighth.
fn of_table(table: &str, local: SocketAddr) -> Option<u32> {
    let IpAddr::V4(address) = local.ip() else { return None };
    let wanted = format!("{:08X}:{:04X}", u32::from_ne_bytes(address.octets()), local.port());
    let of_line = |line: &str| {
        let mut columns = line.split_ascii_whitespace();
        (columns.nth(1)? == wanted).then(|| columns.nth(5)?.parse().ok()).flatten()
    };
    table.lines().skip(1).find_map(of_line)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::net::{Ipv4Addr, TcpListener, TcpStream};

    #[test]
    fn a_socket_is_found_by_its_own_end() {
        let at = |port| SocketAddr::from((Ipv4Addr::LOCALHOST, port));
        let address = format!("{:08X}", u32::from_ne_bytes([127, 0, 0, 1]));
        let table = format!(
            "  sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid  timeout inode\n\
               0: {address}:1F90 00000000:0000 0A 00000000:00000000 00:00000000 00000000  1000        0 1 1 0 100 0\n\
               1: {address}:C350 {address}:1F90 01 00000000:00000000 00:00000000 00000000  1001        0 2 1 0 20 4\n"
        );
        assert_eq!(of_table(&table, at(50000)), Some(1001));
        assert_eq!(of_table(&table, at(8080)), Some(1000));
        assert_eq!(of_table(&table, at(50001)), None);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_connection_of_this_program_belongs_to_its_user() {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).unwrap();
        let client = TcpStream::connect(listener.local_addr().unwrap()).unwrap();
        let owners = Owners::read();
        let user = owners.user_of(client.local_addr().unwrap());
        assert!(user.is_some() && user == owners.own(), "{user:?}");
    }
}
