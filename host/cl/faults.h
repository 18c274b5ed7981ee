// Faults on demand: $PENCIL_FAULT lets a device fail as real ones do, to see what becomes of a render.
#pragma once

#include <cstdint>

namespace pencil {

/// "lost:N": the device is gone from its N-th launch on; "memory:N": its N-th allocation fails, and no other; "memory:N+": and all after it. Of the
/// first device that the process opens; with "@K" behind it, of the K-th.
class Faults {
public:
    /// Takes what $PENCIL_FAULT asks for, if it is for this device. UsageError.
    Faults();

    /// Throws cl::Error.
    void at_launch();
    void at_allocation();

private:
    std::uint64_t launches_ = 0, allocations_ = 0;  // so far
    std::uint64_t lost_at_ = 0, memory_at_ = 0;     // 0: never
    bool memory_stays_short_ = false;
};

}  // namespace pencil
