/// CUDA's functions about streams, events and waits.

#include "tests/ptx/runtime/runtime.h"

using namespace pdr::ptx;

extern "C" {

cudaError_t cudaStreamCreateWithFlags(cudaStream_t* stream, unsigned) {
    return Runtime::get().call("cudaStreamCreateWithFlags", [&](Runtime& r) {
        *stream = new CUstream_st{r.streams.open()};
        return cudaSuccess;
    });
}
cudaError_t cudaStreamDestroy(cudaStream_t stream) {
    return Runtime::get().call("cudaStreamDestroy", [&](Runtime& r) {
        r.streams.awaitStream(stream->number);
        delete stream;
        return cudaSuccess;
    });
}
cudaError_t cudaStreamSynchronize(cudaStream_t stream) {
    return Runtime::get().call("cudaStreamSynchronize", [&](Runtime& r) {
        r.streams.awaitStream(r.numberOf(stream));
        return cudaSuccess;
    });
}
cudaError_t cudaStreamWaitEvent(cudaStream_t stream, cudaEvent_t event, unsigned) {
    return Runtime::get().call("cudaStreamWaitEvent", [&](Runtime& r) {
        if (event->work != nullptr)
            r.streams.add(r.numberOf(stream), "a wait", nullptr, event->work);
        return cudaSuccess;
    });
}
cudaError_t cudaEventCreateWithFlags(cudaEvent_t* event, unsigned) {
    return Runtime::get().call("cudaEventCreateWithFlags", [&](Runtime&) {
        *event = new CUevent_st;
        return cudaSuccess;
    });
}
cudaError_t cudaEventDestroy(cudaEvent_t event) {
    return Runtime::get().call("cudaEventDestroy", [&](Runtime&) {
        delete event;
        return cudaSuccess;
    });
}
cudaError_t cudaEventRecord(cudaEvent_t event, cudaStream_t stream) {
    return Runtime::get().call("cudaEventRecord", [&](Runtime& r) {
        event->work = r.streams.add(r.numberOf(stream), "an event", nullptr);
        return cudaSuccess;
    });
}
cudaError_t cudaEventSynchronize(cudaEvent_t event) {
    return Runtime::get().call("cudaEventSynchronize", [&](Runtime& r) {
        r.streams.await(event->work);
        return cudaSuccess;
    });
}
cudaError_t cudaDeviceSynchronize() {
    return Runtime::get().call("cudaDeviceSynchronize", [&](Runtime& r) {
        r.streams.awaitAll();
        return cudaSuccess;
    });
}

}  // extern "C"
