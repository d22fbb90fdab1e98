#include "render/timing/efficiency.h"

namespace pdr {

double efficiency(double n, const FrameParts& parts) {
    return n * parts.iteration / (n * parts.iteration + parts.other);
}

double framesPerSecond(double n, const FrameParts& parts) {
    return 1 / (n * parts.iteration + parts.other);
}

double iterationsPerSecond(double n, const FrameParts& parts) {
    return n * framesPerSecond(n, parts);
}

double efficiencyAtFrameRate(double framesPerSecond, double other) {
    return 1 - framesPerSecond * other;
}

double efficiencyOfManyNodes(double framesPerSecond, double communication) {
    return 1 - framesPerSecond * communication;
}

double iterationFromFrameRate(double n, double framesPerSecond) {
    return 1 / (n * framesPerSecond);
}

double otherFromFrameRate(double framesPerSecondOfOne, double iteration) {
    return 1 / framesPerSecondOfOne - iteration;
}

double communicationFromFrameRate(double framesPerSecondOfOne, double iteration) {
    return 1 / framesPerSecondOfOne - iteration;
}

double frameSeconds(const FrameTimeModel& model, const FrameWork& work) {
    return work.launches() * model.launch + (work.iterations * model.sample + model.pixel) * work.pixels +
           model.communication;
}

double sampleShare(const FrameTimeModel& model, const FrameWork& work) {
    return work.iterations * model.sample * work.pixels / frameSeconds(model, work);
}

double optimismOfManyNodes(const FrameTimeModel& model, const FrameWork& work) {
    const double seconds = frameSeconds(model, work);
    return efficiencyOfManyNodes(1 / seconds, model.communication) - sampleShare(model, work);
}

}  // namespace pdr
