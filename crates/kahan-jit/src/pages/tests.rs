//! Compares pages with the memory map of this process in `/proc/self/maps`.

use super::Pages;

fn bytes() -> Vec<u8> {
    (0..10_000_u32).map(|k| (k % 251) as u8).collect()
}

#[test]
fn pages_hold_what_they_were_made_from() {
    let bytes = bytes();
    let pages = Pages::new(&bytes).expect("the system gives pages");
    assert_eq!(pages.0[..], bytes);
    assert_eq!(pages.start(), pages.0.as_ptr());
    assert_eq!(pages.start().addr() % 4096, 0);
}

#[test]
fn pages_are_shared_by_threads() {
    fn is_shared<T: Send + Sync>() {}
    is_shared::<Pages>();
}

#[cfg(target_os = "linux")]
mod on_linux {
    use std::env;
    use std::fs;
    use std::ops::Range;
    use std::process::Command;

    use super::{Pages, bytes};

    struct Piece {
        addresses: Range<usize>,
        permissions: String,
    }

    fn pieces() -> Vec<Piece> {
        let maps = fs::read_to_string("/proc/self/maps").expect("Linux lists the memory of a process");
        let piece = |line: &str| {
            let mut words = line.split_whitespace();
            let (start, end) = words.next()?.split_once('-')?;
            let address = |digits| usize::from_str_radix(digits, 16).ok();
            Some(Piece { addresses: address(start)?..address(end)?, permissions: words.next()?.to_owned() })
        };
        maps.lines().map(|line| piece(line).expect("addresses and permissions")).collect()
    }

    #[test]
    fn no_memory_is_writable_and_executable() {
        let pages: Vec<Pages> =
            (0..100).map(|_| Pages::new(&bytes()).expect("the system gives pages")).collect();
        let pieces = pieces();
        for piece in &pieces {
            let is = |permission| piece.permissions.contains(permission);
            assert!(!(is('w') && is('x')), "{:x?} is {}", piece.addresses, piece.permissions);
        }
        for page in &pages {
            let start = page.start().addr();
            let piece = pieces.iter().find(|piece| piece.addresses.contains(&start));
            assert_eq!(piece.expect("it is in memory").permissions, "r-xp");
        }
    }

    /// Counts the executable bytes of this process.
    fn executable() -> usize {
        let pieces = pieces().into_iter().filter(|piece| piece.permissions.contains('x'));
        pieces.map(|piece| piece.addresses.len()).sum()
    }

    #[test]
    fn pages_that_are_dropped_leave_nothing() {
        const PAGES: usize = 10_000;

        let (bytes, before) = (bytes(), executable());
        for _ in 0..PAGES {
            drop(Pages::new(&bytes).expect("the system gives pages"));
        }
        // Other tests run at the same time, but hold far fewer than PAGES / 10 pages.
        let (after, most) = (executable(), before + PAGES / 10 * bytes.len());
        assert!(after < most, "{after} bytes, not {before}");
    }

    /// Runs this test again in a process with 1 GiB of address space, where allocation fails.
    #[test]
    fn a_refusal_of_the_system_is_an_error() {
        const LIMITED: &str = "KAHAN_JIT_LIMITED";
        const TOO_MANY: usize = 600 << 20;

        if env::var_os(LIMITED).is_some() {
            let refused = Pages::new(&vec![0; TOO_MANY]);
            return assert_eq!(refused.expect_err("twice as much").kind(), std::io::ErrorKind::OutOfMemory);
        }
        if !crate::tests::starts_itself() {
            return;
        }
        let test = "pages::tests::on_linux::a_refusal_of_the_system_is_an_error";
        let limited = Command::new("sh")
            .args(["-c", "ulimit -v 1048576 && exec \"$0\" --exact \"$1\" --test-threads 1"])
            .arg(env::current_exe().expect("this program has a name"))
            .arg(test)
            .env(LIMITED, "1")
            .output()
            .expect("there is a shell");
        let said = String::from_utf8_lossy(&limited.stdout);
        assert!(limited.status.success() && said.contains("1 passed"), "{said}");
    }
}
