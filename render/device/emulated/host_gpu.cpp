#include "render/device/emulated/host_gpu.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cstring>
#include <new>
#include <thread>
#include <utility>

#include "render/base/errors.h"

namespace pdr {

namespace {

constexpr std::size_t kAlignment = 256;  ///< bytes
constexpr std::size_t kGrain = 256;      ///< number of indices that is worth a task of its own

std::size_t machineMemory() {
    const long pages = sysconf(_SC_PHYS_PAGES), bytes = sysconf(_SC_PAGESIZE);
    return pages > 0 && bytes > 0 ? std::size_t(pages) * std::size_t(bytes) : 0;
}

int threadsOr(int wanted) {
    return wanted > 0 ? wanted : std::max(int(std::thread::hardware_concurrency()), 1);
}

}  // namespace

struct HostGpu::Threads {
    explicit Threads(int count)
        : allowed(tbb::global_control::max_allowed_parallelism,
                  std::size_t(std::max(count, tbb::this_task_arena::max_concurrency()))),
          arena(count) {}

    tbb::global_control allowed;  ///< allows more threads than cores, if requested
    tbb::task_arena arena;
};

HostGpu::HostGpu(std::size_t totalBytes, int threads, Walks walks)
    : total_(totalBytes > 0 ? totalBytes : machineMemory()),
      threads_(std::make_unique<Threads>(threadsOr(threads))),
      walks_(walks) {}

HostGpu::~HostGpu() {
    for (const auto& [memory, bytes] : allocated_)
        ::operator delete(memory, std::align_val_t(kAlignment));
}

GpuMemory HostGpu::memory() const {
    const std::lock_guard lock(mutex_);
    return {total_, total_ - used_};
}

void HostGpu::distribute(std::int64_t count, Order order,
                         const std::function<void(std::int64_t, std::int64_t)>& piece) {
    using Indices = tbb::blocked_range<std::int64_t>;
    const auto work = [&piece](const Indices& indices) { piece(indices.begin(), indices.end()); };
    threads_->arena.execute([&] {
        if (order == Order::queued)
            tbb::parallel_for(Indices(0, count, 1), work, tbb::simple_partitioner());
        else
            tbb::parallel_for(Indices(0, count, kGrain), work);
    });
}

void* HostGpu::taken(std::size_t bytes) {
    void* memory = ::operator new(std::max<std::size_t>(bytes, 1), std::align_val_t(kAlignment), std::nothrow);
    if (memory != nullptr)
        allocated_[memory] = bytes;
    return memory;
}

std::size_t HostGpu::given(void* memory) {
    const auto found = allocated_.find(memory);
    assert(found != allocated_.end());
    const std::size_t bytes = found->second;
    allocated_.erase(found);
    ::operator delete(memory, std::align_val_t(kAlignment));
    return bytes;
}

void* HostGpu::allocate(std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    if (error_)
        return nullptr;
    const std::size_t free = total_ - used_;
    void* memory = bytes <= free ? taken(bytes) : nullptr;
    if (memory == nullptr)
        error_ = memoryTooSmall(name(), bytes, free);
    else
        used_ += bytes;
    return memory;
}

void HostGpu::release(void* memory) {
    const std::lock_guard lock(mutex_);
    if (memory != nullptr)
        used_ -= given(memory);
}

void* HostGpu::allocatePinned(std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    if (error_)
        return nullptr;
    void* memory = taken(bytes);
    if (memory == nullptr)
        error_ = memoryTooSmall("the computer", bytes, 0);
    else
        pinned_ += bytes;
    return memory;
}

void HostGpu::releasePinned(void* memory) {
    const std::lock_guard lock(mutex_);
    if (memory != nullptr)
        pinned_ -= given(memory);
}

std::uint64_t HostGpu::makeTexture(const std::int16_t*, ivec3 size) {
    return reinterpret_cast<std::uint64_t>(allocate(std::size_t(size.x) * size.y * size.z * sizeof(std::int16_t)));
}

void HostGpu::copyToDevice(void* to, const void* from, std::size_t bytes, GpuStream) {
    if (!failed() && bytes > 0)
        std::memcpy(to, from, bytes);
}

void HostGpu::copyToHost(void* to, const void* from, std::size_t bytes, GpuStream) {
    if (!failed() && bytes > 0)
        std::memcpy(to, from, bytes);
}

void HostGpu::clear(void* memory, std::size_t bytes, GpuStream) {
    if (!failed() && bytes > 0)
        std::memset(memory, 0, bytes);
}

void HostGpu::fail(Error error) {
    const std::lock_guard lock(mutex_);
    if (!error_)
        error_ = std::move(error);
}

bool HostGpu::failed() const {
    const std::lock_guard lock(mutex_);
    return error_.has_value();
}

std::optional<Error> HostGpu::takeError() {
    const std::lock_guard lock(mutex_);
    return std::exchange(error_, std::nullopt);
}

std::size_t HostGpu::allocated() const {
    const std::lock_guard lock(mutex_);
    return used_ + pinned_;
}

}  // namespace pdr
