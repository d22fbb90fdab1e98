#include "render/device/cuda/cuda_gpu.h"

#include "render/device/gpu/memory_error.h"

namespace pdr {

CudaGpu::Event::~Event() {
    if (event_ != nullptr)
        cudaEventDestroy(event_);
}

CudaGpu::CudaGpu(int index) : index_(index), name_("cuda:" + std::to_string(index)) {
    cudaDeviceProp properties{};
    if (!check(cudaGetDeviceProperties(&properties, index), "the first call") || !ready())
        return;
    name_ = properties.name;
    for (cudaStream_t& stream : streams_)
        check(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), "making a stream");
    next_ = static_cast<unsigned long long*>(allocate(sizeof *next_));
}

CudaGpu::~CudaGpu() {
    cudaSetDevice(index_);
    release(next_);
    for (cudaStream_t stream : streams_)
        if (stream != nullptr)
            cudaStreamDestroy(stream);
}

bool CudaGpu::ready() {
    return !error_ && check(cudaSetDevice(index_), "choosing it");
}

bool CudaGpu::check(cudaError_t status, const char* doing) {
    if (status == cudaSuccess)
        return true;
    if (!error_)
        error_ = Error{std::string("the GPU failed at ") + doing + " (" + cudaGetErrorString(status) + ")", name_,
                       "Render on the CPU; a newer driver or a restart of the computer may help."};
    return false;
}

std::optional<Error> CudaGpu::takeError() {
    cudaGetLastError();  // what is kept by the runtime of a passing error; a lost device stays lost
    return std::exchange(error_, std::nullopt);
}

GpuMemory CudaGpu::memory() const {
    GpuMemory memory;
    if (cudaSetDevice(index_) != cudaSuccess || cudaMemGetInfo(&memory.free, &memory.total) != cudaSuccess)
        return {};
    return memory;
}

void* CudaGpu::allocate(std::size_t bytes) {
    void* memory = nullptr;
    if (!ready() || bytes == 0)
        return nullptr;
    const cudaError_t status = cudaMalloc(&memory, bytes);
    if (status == cudaErrorMemoryAllocation)
        error_ = memoryTooSmall(name_, bytes, this->memory().free);
    else
        check(status, "taking memory");
    return status == cudaSuccess ? memory : nullptr;
}

void CudaGpu::release(void* memory) {
    if (memory == nullptr)
        return;
    cudaSetDevice(index_);
    cudaFree(memory);
}

void* CudaGpu::allocatePinned(std::size_t bytes) {
    void* memory = nullptr;
    if (!ready() || !check(cudaHostAlloc(&memory, bytes, cudaHostAllocDefault), "taking memory of the host"))
        return nullptr;
    return memory;
}

void CudaGpu::releasePinned(void* memory) {
    if (memory != nullptr)
        cudaFreeHost(memory);
}

void CudaGpu::copyToDevice(void* to, const void* from, std::size_t bytes, GpuStream stream) {
    if (bytes > 0 && ready())
        check(cudaMemcpyAsync(to, from, bytes, cudaMemcpyHostToDevice, of(stream)), "copying to it");
}

void CudaGpu::copyToHost(void* to, const void* from, std::size_t bytes, GpuStream stream) {
    if (bytes > 0 && ready())
        check(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToHost, of(stream)), "copying from it");
}

void CudaGpu::clear(void* memory, std::size_t bytes, GpuStream stream) {
    if (bytes > 0 && ready())
        check(cudaMemsetAsync(memory, 0, bytes, of(stream)), "clearing memory");
}

void CudaGpu::record(Event& event, GpuStream stream) {
    if (!ready())
        return;
    if (event.event_ == nullptr &&
        !check(cudaEventCreateWithFlags(&event.event_, cudaEventDisableTiming), "making an event"))
        return;
    check(cudaEventRecord(event.event_, of(stream)), "recording an event");
}

void CudaGpu::wait(GpuStream stream, Event& event) {
    if (event.event_ != nullptr && ready())
        check(cudaStreamWaitEvent(of(stream), event.event_, 0), "waiting for an event");
}

void CudaGpu::await(Event& event) {
    if (event.event_ != nullptr && ready())
        check(cudaEventSynchronize(event.event_), "a launch");
}

void CudaGpu::awaitAll() {
    if (ready())
        check(cudaDeviceSynchronize(), "a launch");
}

unsigned CudaGpu::residentBlocks(const void* kernel) {
    unsigned& blocks = residentBlocks_[kernel];
    if (blocks == 0) {
        int each = 0, processors = 0;
        check(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&each, kernel, kThreads, 0), "a launch");
        check(cudaDeviceGetAttribute(&processors, cudaDevAttrMultiProcessorCount, index_), "a launch");
        blocks = unsigned(std::max(each * processors, 1));
    }
    return blocks;
}

}  // namespace pdr
