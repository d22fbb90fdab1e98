#pragma once
/// Options of `pdrender-cli cluster`.

#include <QStringList>
#include <string>

#include "render/base/result.h"

namespace pdr::app {

struct ClusterOptions {
    bool help = false;
    int nodes = 0;          ///< number of nodes, each a task of the job, [1, 10000]
    QString listen;         ///< address that nodes dial, "[HOST:]PORT"
    QString host;           ///< name by which nodes know this machine; empty: that of `listen`, or the machine's own
    QString bundle;         ///< folder of this machine's certificates; empty: none
    QString nodeBundle;     ///< folder of the nodes' certificates; empty: none
    int waitSeconds = 300;  ///< longest time until all nodes are connected
    int keepSeconds = 600;  ///< time for which nodes go on dialling while nobody listens
    int idleMinutes = 10;   ///< time without work after which a node ends
    QStringList sbatch;     ///< further arguments of sbatch
};

/// Parses `arguments`. Errors name the option in `where`.
Result<ClusterOptions> clusterOptions(const QStringList& arguments);
std::string clusterHelp();

}  // namespace pdr::app
