//! How much memory the process has used, where the system keeps it in a file.

/// The most memory used so far, in bytes; None where the system does not tell.
pub fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok()?.checked_mul(1024)
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    #[test]
    fn the_peak_counts_what_was_used() {
        let before = super::peak().unwrap();
        let used = std::hint::black_box(vec![1_u8; 64 << 20]);
        assert!(super::peak().unwrap() >= before.max(used.len() as u64));
    }
}
