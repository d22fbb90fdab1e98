#pragma once
/// Makes the certificates by which coordinator and nodes authenticate each other: a bundle, which is a folder with
///   coordinator/   ca.pem, certificate.pem, key.pem   stays with the coordinator
///   node/          the same files                     is copied to all nodes
///   node-1/ ...    or these: one for each node
/// One private authority (P-256), whose key is discarded, signs all certificates: a peer without a certificate of this
/// bundle is a stranger, and no two certificates of it have one name. Keys are readable by their owner only (0600),
/// folders are 0700.

#include <QString>
#include <chrono>

#include "render/base/result.h"

namespace pdr::remote {

inline constexpr std::chrono::days kCertificatesHold{825};

/// Writes a bundle into `folder`, which it creates if it is missing. Writes all or nothing. `nodes`: how many nodes get
/// a certificate of their own; 0: all share one. The certificates are valid from a day before `now`, since clocks
/// differ. Errors: there is a bundle already, the folder cannot be written.
Result<void> makeCertificates(const QString& folder, int nodes = 0,
                              std::chrono::system_clock::time_point now = std::chrono::system_clock::now());

}  // namespace pdr::remote
