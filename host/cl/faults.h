// Faults on demand: $PENCIL_FAULT lets the first device that is opened fail as real ones do, to see what becomes of a render.
#pragma once

#include <cstdint>

namespace pencil {

/// "lost:N": the device is gone from its N-th launch on; "memory:N": its N-th allocation fails, and no other; "memory:N+": and all after it.
class Faults {
public:
    /// Takes what $PENCIL_FAULT asks for: only the first of a process gets it. UsageError.
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
