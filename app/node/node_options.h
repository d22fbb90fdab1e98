#pragma once
/// Options of pdrender-node, from its command line and its environment; the command line has precedence.

#include <QStringList>
#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "app/remote/address.h"
#include "render/base/result.h"

namespace pdr::node {

struct NodeOptions {
    std::optional<remote::Address> coordinator;  ///< address to dial; either this or `listen` is set
    std::optional<remote::Address> listen;       ///< address to listen at
    QString bundle;                              ///< folder of certificates; empty: none
    QString relay;                     ///< address at which nodes below may dial this one; empty: it is no relay
    QString relayBundle;               ///< a coordinator's folder of certificates, for the nodes below; empty: none
    bool checksAll = false;            ///< with `relay`: all that nodes below send is rendered twice
    QString name;                      ///< name that users see; by default that of this machine
    std::string device = "auto";       ///< device, as openDevice() takes it
    int threads = 0;                   ///< threads of the CPU; 0: one per core
    int coordinators = 4;              ///< coordinators with a scan at a time; more wait in line
    std::chrono::minutes idle{0};      ///< time without work after which the node ends; 0: never ends
    std::chrono::seconds drain{8};     ///< time to finish open leases when the node is to end
    std::chrono::seconds giveUp{120};  ///< time after which an unreachable coordinator is given up
    QString makeCertificates;          ///< folder to write a bundle into; empty: none is requested
    int certificates = 0;              ///< number of nodes with one of their own; 0: they share
    bool help = false, version = false;
};

/// Parses the options. `arguments`: those after the program's name; `environment`: returns the value of a variable,
/// empty if it is not set. Errors name the option in `where`.
Result<NodeOptions> nodeOptions(const QStringList& arguments, const std::function<QString(const char*)>& environment);
/// Returns the text of --help.
std::string nodeHelp();

}  // namespace pdr::node
