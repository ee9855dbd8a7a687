//! What the processor at hand has.

/// Whether [`dispatch`](crate::dispatch::dispatch) runs on fused numbers on this machine.
#[inline]
pub fn is_fused() -> bool {
    #[cfg(target_arch = "x86_64")]
    {
        is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")
    }
    #[cfg(not(target_arch = "x86_64"))]
    {
        cfg!(target_arch = "aarch64")
    }
}
