#pragma once
/// Runs ptx_images, which renders one image three times on the CUDA device.

#include "tests/support/program_run.h"

namespace pdr::test {

/// Runs it on `device`. `settings`: what stands behind PDR_PTX_ in resources/manual/ptx.md, "FAIL=7 TRACE=1".
inline ProgramRun images(const QString& settings, const QString& device = "cuda") {
    return runProgram("../tests/ptx_images", {device}, [&](QProcess& process) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const QString& setting : settings.split(' ', Qt::SkipEmptyParts))
            environment.insert("PDR_PTX_" + setting.section('=', 0, 0), setting.section('=', 1));
        process.setProcessEnvironment(environment);
    });
}

}  // namespace pdr::test
