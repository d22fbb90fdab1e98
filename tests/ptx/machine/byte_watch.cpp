#include "tests/ptx/machine/byte_watch.h"

#include <cstring>

#include "tests/ptx/machine/pages.h"

namespace pdr::ptx {

ByteWatch::ByteWatch(const Settings& settings, u64 room) {
    if (settings.unset)
        written_ = reserve<u8>(room);
    if (settings.races)
        meetings_ = reserve<Meeting>(room);
}

void ByteWatch::markWritten(u64 at, u64 bytes) {
    if (written_ != nullptr)
        std::memset(written_ + at, 1, bytes);
}

const char* ByteWatch::wrongAt(const Meeting& meeting, Access access, u32 me) {
    const bool otherWrote = meeting.writer != 0 && meeting.writer != me;
    const bool otherRead = meeting.reader != 0 && (meeting.reader != me || meeting.manyReaders);
    if (access == Access::write && otherWrote)
        return "writes where another thread of the launch writes";
    if (access == Access::atomic && otherWrote && !meeting.byAtomics)
        return "changes what another thread of the launch writes without an atomic";
    if (access == Access::read && otherWrote)
        return meeting.byAtomics ? "reads plainly what another thread of the launch changes by an atomic"
                                 : "reads what another thread of the launch writes";
    if (access == Access::relaxedRead && otherWrote && !meeting.byAtomics)
        return "reads what another thread of the launch writes";
    if (isWrite(access) && otherRead && !(access == Access::atomic && meeting.onlyRelaxed))
        return "writes what another thread of the launch has read";
    return nullptr;
}

void ByteWatch::note(Meeting& meeting, Access access, u32 me) {
    if (isWrite(access)) {
        meeting.byAtomics = access == Access::atomic && (meeting.writer == 0 || meeting.byAtomics);
        meeting.writer = me;
    } else {
        meeting.onlyRelaxed = access == Access::relaxedRead && (meeting.reader == 0 || meeting.onlyRelaxed);
        meeting.manyReaders = meeting.manyReaders || (meeting.reader != 0 && meeting.reader != me);
        meeting.reader = me;
    }
}

const char* ByteWatch::access(u64 at, u32 bytes, Access access, Accessor who) {
    const char* wrong = nullptr;
    if (written_ != nullptr) {
        if (access != Access::write && std::memchr(written_ + at, 0, bytes) != nullptr)
            wrong = "reads what nobody has written";
        if (isWrite(access))
            markWritten(at, bytes);
    }
    for (u32 i = 0; meetings_ != nullptr && i < bytes; ++i) {
        Meeting& meeting = meetings_[at + i];
        if (meeting.launch != who.launch)
            meeting = {who.launch};
        if (const char* met = wrongAt(meeting, access, who.thread + 1); met != nullptr)
            wrong = met;
        note(meeting, access, who.thread + 1);
    }
    return wrong;
}

void ByteWatch::forget(u64 at, u64 bytes) {
    if (meetings_ != nullptr)
        madvise(meetings_ + at, bytes * sizeof(Meeting), MADV_DONTNEED);
}

}  // namespace pdr::ptx
