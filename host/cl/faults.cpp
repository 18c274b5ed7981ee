#include "cl/faults.h"

#include <atomic>
#include <cstdlib>
#include <string>

#include "cl/opencl.h"
#include "util/environment.h"
#include "util/error.h"

namespace pencil {

Faults::Faults() {
    static std::atomic<int> opened{0};
    const int device = ++opened;
    const std::string text = environment("PENCIL_FAULT");
    const std::size_t place = text.find('@'), colon = text.find(':');
    if (text.empty() || std::to_string(device) != (place == std::string::npos ? "1" : text.substr(place + 1))) return;
    const std::string kind = text.substr(0, colon), number = colon == std::string::npos ? "" : text.substr(colon + 1, place - colon - 1);
    char* end = nullptr;
    const std::uint64_t at = std::strtoull(number.c_str(), &end, 10);
    const std::string rest = end;
    memory_stays_short_ = kind == "memory" && rest == "+";
    if (at == 0 || (kind != "lost" && kind != "memory") || !(rest.empty() || memory_stays_short_))
        throw UsageError("PENCIL_FAULT=" + text + " is not lost:N, memory:N or memory:N+ with N from 1, and perhaps @K behind it");
    (kind == "lost" ? lost_at_ : memory_at_) = at;
}

void Faults::at_launch() {
    if (lost_at_ > 0 && ++launches_ >= lost_at_) throw cl::Error(CL_INVALID_COMMAND_QUEUE, "PENCIL_FAULT");
}

void Faults::at_allocation() {
    if (memory_at_ == 0) return;
    ++allocations_;
    if (allocations_ == memory_at_ || (memory_stays_short_ && allocations_ > memory_at_))
        throw cl::Error(CL_MEM_OBJECT_ALLOCATION_FAILURE, "PENCIL_FAULT");
}

}  // namespace pencil
