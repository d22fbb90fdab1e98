#include "app/cli/example_command.h"

#include <cstdio>
#include <optional>

#include "app/cli/cranium.h"
#include "dicom/export.h"
#include "render/volume/phantom.h"

namespace pdr::app {

namespace {

struct Request {
    std::string folder;
    std::string cranium;  ///< empty: the phantom
};

std::optional<Request> parse(QStringList arguments) {
    Request request;
    if (const qsizetype at = arguments.indexOf(QStringLiteral("--cranium")); at >= 0) {
        if (at + 1 >= arguments.size())
            return {};
        request.cranium = arguments.takeAt(at + 1).toStdString();
        arguments.removeAt(at);
    }
    if (arguments.size() != 1 || arguments.front().startsWith('-'))
        return {};
    request.folder = arguments.front().toStdString();
    return request;
}

dicom::ExportFacts factsOf(const Request& request) {
    if (request.cranium.empty())
        return {"Phantom^Head", "PHANTOM", "PD-Render example", "Head phantom",
                "An analytic head phantom, computed by PD-Render. No patient."};
    return {"Example^Cranium", "CRANIUM", "PD-Render example", "Head with cranial defect",
            "Written by PD-Render from the voxels of Cranium.inv3, an example of InVesalius."};
}

/// A line at every tenth part.
Progress linesOnStderr() {
    return [next = 0.1](double fraction, std::string_view step) mutable {
        for (; fraction >= next - 1e-9; next += 0.1)
            std::fprintf(stderr, "%.*s: %.0f %%\n", int(step.size()), step.data(), next * 100);
        return true;
    };
}

}  // namespace

int runExample(const QStringList& arguments) {
    const std::optional<Request> request = parse(arguments);
    if (!request) {
        std::fprintf(stderr, "usage: pdrender-cli example FOLDER [--cranium MATRIX.DAT]\n");
        return 2;
    }
    if (request->cranium.empty())
        std::fprintf(stderr, "No real CT was given: computing an analytic head phantom in its place.\n");
    const Result<Volume> volume =
        request->cranium.empty() ? Result<Volume>(headPhantom()) : readCranium(request->cranium);
    if (!volume) {
        std::fprintf(stderr, "%s\n", volume.error().text().c_str());
        return 1;
    }
    const Result<void> written = dicom::writeSeries(*volume, factsOf(*request), request->folder, linesOnStderr());
    if (!written) {
        std::fprintf(stderr, "%s\n", written.error().text().c_str());
        return 1;
    }
    std::fprintf(stderr, "%d slices written to %s\n", volume->size().z, request->folder.c_str());
    return 0;
}

}  // namespace pdr::app
