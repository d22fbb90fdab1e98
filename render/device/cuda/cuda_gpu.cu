#include "render/device/cuda/cuda_gpu.h"

#include <algorithm>

#include "render/base/errors.h"
#include "render/device/cuda/cuda_errors.h"

namespace pdr {
namespace {

/// Ignores the status of a call that nothing depends on. Clears it in the runtime, too, since the next launch would
/// report it.
void ignore(cudaError_t status) {
    if (status != cudaSuccess)
        cudaGetLastError();
}

}  // namespace

CudaGpu::Event::~Event() {
    if (event_ != nullptr)
        ignore(cudaEventDestroy(event_));
}

CudaGpu::CudaGpu(int index, std::string name, PreparationObserver preparing)
    : index_(index), name_(std::move(name)), preparing_(std::move(preparing)) {
    if (!ready())
        return;
    for (cudaStream_t& stream : streams_)
        check(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), "making a stream");
    next_ = static_cast<std::uint64_t*>(allocate(sizeof *next_));
    choosePathsTogether();
}

CudaGpu::~CudaGpu() {
    ignore(cudaSetDevice(index_));
    release(next_);
    for (cudaStream_t stream : streams_)
        if (stream != nullptr)
            ignore(cudaStreamDestroy(stream));
}

bool CudaGpu::ready() {
    return !error_ && check(cudaSetDevice(index_), "choosing it");
}

bool CudaGpu::check(cudaError_t status, const char* doing) {
    if (status == cudaSuccess)
        return true;
    if (!error_)
        error_ = cudaFailure(status, name_, doing);
    return false;
}

std::optional<Error> CudaGpu::takeError() {
    cudaGetLastError();  // clears what the runtime keeps of a passing error; a lost device stays lost
    return std::exchange(error_, std::nullopt);
}

GpuMemory CudaGpu::memory() const {
    GpuMemory memory;
    const bool isThere = cudaSetDevice(index_) == cudaSuccess;
    if (isThere && cudaMemGetInfo(&memory.free, &memory.total) == cudaSuccess)
        return memory;
    cudaGetLastError();
    return {};
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
    ignore(cudaSetDevice(index_));
    ignore(cudaFree(memory));
}

void* CudaGpu::allocatePinned(std::size_t bytes) {
    void* memory = nullptr;
    if (!ready())
        return nullptr;
    const cudaError_t status = cudaHostAlloc(&memory, bytes, cudaHostAllocDefault);
    if (status == cudaErrorMemoryAllocation)
        error_ = notEnoughMemory(phrase("for images that come from the GPU"), "",
                                 phrase("Close programs, or make the image smaller."));
    else
        check(status, "taking memory of the computer");
    return status == cudaSuccess ? memory : nullptr;
}

void CudaGpu::releasePinned(void* memory) {
    if (memory != nullptr)
        ignore(cudaFreeHost(memory));
}

bool CudaGpu::textureFits(ivec3 size) {
    ivec3 most(0);
    const cudaDeviceAttr limits[] = {cudaDevAttrMaxTexture3DWidth, cudaDevAttrMaxTexture3DHeight,
                                     cudaDevAttrMaxTexture3DDepth};
    for (int axis = 0; axis < 3; ++axis)
        if (!check(cudaDeviceGetAttribute(&most[axis], limits[axis], index_), "asking how large textures may be"))
            return false;
    const auto text = [](ivec3 voxels) { return phrase("%1 x %2 x %3", voxels.x, voxels.y, voxels.z); };
    if (size.x <= most.x && size.y <= most.y && size.z <= most.z)
        return true;
    error_ = Error{phrase("the volume is too large for fast filtering: it has %1 voxels, textures may have %2",
                          text(size), text(most)),
                   name_, phrase("Choose exact filtering."), ErrorKind::refused};
    return false;
}

cudaTextureObject_t CudaGpu::textureOf(cudaArray_t array) {
    cudaResourceDesc resource{};
    resource.resType = cudaResourceTypeArray;
    resource.res.array.array = array;
    cudaTextureDesc reading{};
    for (cudaTextureAddressMode& mode : reading.addressMode)
        mode = cudaAddressModeClamp;
    reading.filterMode = cudaFilterModeLinear;
    reading.readMode = cudaReadModeNormalizedFloat;
    cudaTextureObject_t texture = 0;
    return check(cudaCreateTextureObject(&texture, &resource, &reading, nullptr), "making a texture") ? texture : 0;
}

std::uint64_t CudaGpu::makeTexture(const std::int16_t* voxels, ivec3 size) {
    if (!ready() || !textureFits(size))
        return 0;
    const std::size_t x = std::size_t(size.x), y = std::size_t(size.y), z = std::size_t(size.z);
    const cudaChannelFormatDesc format = cudaCreateChannelDesc<short>();
    cudaArray_t array = nullptr;
    const cudaError_t status = cudaMalloc3DArray(&array, &format, make_cudaExtent(x, y, z));
    if (status == cudaErrorMemoryAllocation)
        error_ = memoryTooSmall(name_, x * y * z * sizeof *voxels, memory().free);
    if (error_ || !check(status, "taking memory for a texture"))
        return 0;
    cudaMemcpy3DParms copy{};
    copy.srcPtr = make_cudaPitchedPtr(const_cast<std::int16_t*>(voxels), x * sizeof *voxels, x, y);
    copy.dstArray = array;
    copy.extent = make_cudaExtent(x, y, z);
    copy.kind = cudaMemcpyHostToDevice;
    const bool copied = check(cudaMemcpy3DAsync(&copy, of(GpuStream::compute)), "copying a texture to it");
    const cudaTextureObject_t texture = copied ? textureOf(array) : 0;
    if (texture == 0) {
        ignore(cudaStreamSynchronize(of(GpuStream::compute)));
        ignore(cudaFreeArray(array));
    }
    return texture;
}

void CudaGpu::releaseTexture(std::uint64_t texture) {
    if (texture == 0)
        return;
    ignore(cudaSetDevice(index_));
    ignore(cudaStreamSynchronize(of(GpuStream::compute)));
    cudaResourceDesc resource{};
    const cudaError_t known = cudaGetTextureObjectResourceDesc(&resource, texture);
    ignore(known);
    ignore(cudaDestroyTextureObject(texture));
    if (known == cudaSuccess)
        ignore(cudaFreeArray(resource.res.array.array));
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

/// cudaFuncGetAttributes() needs the machine code: it returns when there is some.
void CudaGpu::prepare(const std::vector<const void*>& kernels) {
    const auto isKnown = [this](const void* kernel) { return prepared_.contains(kernel); };
    if (!preparing_ || std::all_of(kernels.begin(), kernels.end(), isKnown) || !ready())
        return;
    preparing_(true);
    for (const void* kernel : kernels) {
        cudaFuncAttributes attributes{};
        if (!check(cudaFuncGetAttributes(&attributes, kernel), "preparing it"))
            break;
        prepared_.insert(kernel);
    }
    preparing_(false);
}

void CudaGpu::choosePathsTogether() {
    constexpr std::int64_t kPathsPerThread = 32, kThreadsPerProcessor = 1024;  // about as many as registers allow
    constexpr std::size_t kBytesPerPath = 360;
    int processors = 0;
    ignore(cudaDeviceGetAttribute(&processors, cudaDevAttrMultiProcessorCount, index_));
    const auto affordable = std::int64_t(memory().total / 16 / kBytesPerPath);
    pathsTogether_ = std::max(kFewestPaths, std::min(processors * kThreadsPerProcessor * kPathsPerThread, affordable));
}

unsigned CudaGpu::residentBlocks(const void* kernel) {
    if (const auto known = residentBlocks_.find(kernel); known != residentBlocks_.end())
        return known->second;
    int each = 0, processors = 0;
    if (!check(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&each, kernel, kThreads, 0), "a launch") ||
        !check(cudaDeviceGetAttribute(&processors, cudaDevAttrMultiProcessorCount, index_), "a launch"))
        return 0;
    return residentBlocks_[kernel] = unsigned(std::max(each * processors, 1));
}

}  // namespace pdr
