#pragma once
/// What `pdrender-cli cluster` is asked for.

#include <QStringList>
#include <string>

#include "render/base/result.h"

namespace pdr::app {

struct ClusterOptions {
    bool help = false;
    int nodes = 0;       ///< tasks of the job, [1, 10000]
    QString listen;      ///< where they dial, "[HOST:]PORT"
    QString host;        ///< by which they know this machine
    QString bundle;      ///< this machine's certificates; empty: none
    QString nodeBundle;  ///< theirs; empty: none
    int waitSeconds = 300;
    int keepSeconds = 600;  ///< that they go on dialling when there is nobody
    int idleMinutes = 10;
    QStringList sbatch;  ///< words for it
};

/// Errors name the option in `where`.
Result<ClusterOptions> clusterOptions(const QStringList& arguments);
std::string clusterHelp();

}  // namespace pdr::app
