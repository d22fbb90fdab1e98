#include "app/cli/scan/example_command.h"

#include <cstdio>
#include <optional>

#include "app/cli/failed.h"
#include "app/cli/progress_line.h"
#include "app/cli/scan/cranium.h"
#include "app/program/interrupt.h"
#include "dicom/write/export.h"
#include "render/volume/phantom.h"

namespace pdr::app {

namespace {

constexpr const char* kHelp =
    "pdrender-cli example FOLDER [--cranium MATRIX.DAT]\n"
    "\n"
    "Writes a DICOM CT series into FOLDER, which must be new or empty: a head with a cranial defect from the voxels "
    "that\n"
    "InVesalius ships (matrix.dat out of Cranium.inv3), or without them a computed head phantom.\n";

struct Request {
    std::string folder;
    std::string cranium;  ///< path of matrix.dat; empty: the phantom
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
        return {"Phantom^Head",
                "PHANTOM",
                "PD-Render example",
                "Head phantom",
                "An analytic head phantom, computed by PD-Render. No patient.",
                "HEAD"};
    return {"Example^Cranium",
            "CRANIUM",
            "PD-Render example",
            "Head with cranial defect",
            "Written by PD-Render from the voxels of Cranium.inv3, an example of InVesalius.",
            "HEAD"};
}

Result<Volume> voxelsOf(const Request& request) {
    if (!request.cranium.empty())
        return readCranium(request.cranium);
    std::fprintf(stderr, "No real CT was given: computing an analytic head phantom in its place.\n");
    return headPhantom();
}

Result<int> writeExample(const Request& request, const std::stop_token& stop) {
    const Result<Volume> volume = voxelsOf(request);
    if (!volume)
        return volume.error();
    ProgressLine line;
    const Result<void> written = dicom::writeSeries(*volume, factsOf(request), request.folder, line.until(stop));
    if (!written)
        return written.error();
    return volume->size().z;
}

}  // namespace

int runExample(const QStringList& arguments) {
    if (arguments.contains("--help") || arguments.contains("-h")) {
        std::fputs(kHelp, stdout);
        return 0;
    }
    const std::optional<Request> request = parse(arguments);
    if (!request) {
        std::fprintf(stderr, "usage: %s", kHelp);
        return 2;
    }
    const Interrupt interrupt;
    const Result<int> slices = writeExample(*request, interrupt.token());
    if (!slices)
        return failed(slices.error());
    std::fprintf(stderr, "%d slices written to %s\n", *slices, request->folder.c_str());
    return 0;
}

}  // namespace pdr::app
