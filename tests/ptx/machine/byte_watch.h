#pragma once
/// Watches each byte of the device's memory: has anybody written it, and do threads of a launch meet there?

#include "tests/ptx/base/settings.h"
#include "tests/ptx/machine/access.h"

namespace pdr::ptx {

class ByteWatch {
  public:
    /// `room`: bytes of the device's addresses. Watches what the settings ask for.
    ByteWatch(const Settings& settings, u64 room);

    bool isOn() const { return written_ != nullptr || meetings_ != nullptr; }
    /// Bytes [at, at + bytes) get values by a copy or a clearing.
    void markWritten(u64 at, u64 bytes);
    /// Returns what is wrong with an access of a thread's, as the end of a sentence; null: nothing.
    const char* access(u64 at, u32 bytes, Access access, Accessor who);
    void forget(u64 at, u64 bytes);

  private:
    /// Who came to a byte last.
    struct Meeting {
        u32 launch = 0;
        u32 writer = 0, reader = 0;  ///< thread + 1; 0: nobody
        bool byAtomics = false;      ///< all that wrote
        bool manyReaders = false;
        bool onlyRelaxed = false;  ///< all that read
    };
    static const char* wrongAt(const Meeting& meeting, Access access, u32 me);
    static void note(Meeting& meeting, Access access, u32 me);

    u8* written_ = nullptr;  ///< 1: yes
    Meeting* meetings_ = nullptr;
};

}  // namespace pdr::ptx
