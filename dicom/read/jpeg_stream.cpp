#include "dicom/read/jpeg_stream.h"

namespace pdr::dicom {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint8_t kStart = 0xD8, kEnd = 0xD9, kScan = 0xDA, kQuantisation = 0xDB, kHuffman = 0xC4, kRestart = 0xDD;

JpegStream::Kind kindOf(std::uint8_t marker) {
    switch (marker) {
        case 0xC0:
        case 0xC1:
            return JpegStream::Kind::sequential;
        case 0xC2:
            return JpegStream::Kind::progressive;
        case 0xC3:
            return JpegStream::Kind::lossless;
        case 0xF7:
            return JpegStream::Kind::jpegLs;
        default:
            return JpegStream::Kind::other;
    }
}

/// Returns whether a marker begins a frame: SOF0..SOF15 without DHT, JPG and DAC, which share their range; SOF55 is
/// JPEG-LS.
bool isFrameHeader(std::uint8_t marker) {
    const bool inRange = marker >= 0xC0 && marker <= 0xCF;
    return marker == 0xF7 || (inRange && marker != 0xC4 && marker != 0xC8 && marker != 0xCC);
}

bool isRestart(std::uint8_t marker) {
    return marker >= 0xD0 && marker <= 0xD7;
}

int word(Bytes bytes, std::size_t at) {
    return int(bytes[at]) << 8 | int(bytes[at + 1]);
}

class Reader {
  public:
    explicit Reader(Bytes stream) : stream_(stream) {}

    JpegStream read() {
        if (stream_.size() < 2 || stream_[0] != 0xFF || stream_[1] != kStart)
            return damaged(phrase("it does not begin as a JPEG image")), found_;
        at_ = 2;
        while (found_.damage.empty() && !ended_)
            segment();
        if (found_.damage.empty() && found_.kind != JpegStream::Kind::jpegLs && found_.scans.empty())
            damaged(phrase("it holds no image"));
        return found_;
    }

  private:
    void damaged(Text damage) {
        if (found_.damage.empty())
            found_.damage = std::move(damage);
    }

    void segment() {
        if (at_ + 2 > stream_.size())
            return damaged(phrase("it ends without its end marker"));
        if (stream_[at_] != 0xFF)
            return damaged(phrase("between its segments lie bytes that belong to none"));
        const std::uint8_t marker = stream_[at_ + 1];
        if (marker == 0xFF) {
            ++at_;  // fill bytes may stand before a marker
            return;
        }
        at_ += 2;
        if (marker == kEnd) {
            ended_ = true;
            return;
        }
        if (marker < 0xC0 || marker == kStart || isRestart(marker))
            return damaged(phrase("it holds a marker where none belongs"));
        if (at_ + 2 > stream_.size() || word(stream_, at_) < 2 ||
            at_ + std::size_t(word(stream_, at_)) > stream_.size())
            return damaged(phrase("one of its segments is longer than the image"));
        const Bytes content = stream_.subspan(at_ + 2, std::size_t(word(stream_, at_)) - 2);
        at_ += 2 + content.size();
        understand(marker, content);
    }

    void understand(std::uint8_t marker, Bytes content) {
        if (isFrameHeader(marker))
            frame(marker, content);
        else if (marker == kHuffman)
            huffman(content);
        else if (marker == kQuantisation)
            quantisation(content);
        else if (marker == kRestart && content.size() >= 2)
            restartInterval_ = word(content, 0);
        else if (marker == kScan)
            scan(content);
    }

    void frame(std::uint8_t marker, Bytes content) {
        if (found_.kind != JpegStream::Kind::none)
            return damaged(phrase("it has two frame headers"));
        if (content.size() < 6)
            return damaged(phrase("its frame header is too short"));
        found_.kind = kindOf(marker);
        found_.precision = content[0];
        found_.size = {word(content, 3), word(content, 1)};
        found_.components = content[5];
        quantisationTable_ = content.size() >= 9 ? content[8] & 3 : 0;
        // The scans of JPEG-LS have rules of their own, which its decoder checks.
        ended_ = found_.kind == JpegStream::Kind::jpegLs;
    }

    void huffman(Bytes content) {
        while (!content.empty()) {
            if (content.size() < 17 || (content[0] & 0x0F) > 3 || content[0] >> 4 > 1)
                return damaged(phrase("one of its code tables is cut off"));
            HuffmanCode code;
            std::size_t symbols = 0;
            unsigned room = 1u << 16;  // room left for codes, in codes of 16 bits
            for (int length = 1; length <= 16; ++length) {
                code.counts[length] = content[length];
                symbols += content[length];
                if (unsigned(content[length]) << (16 - length) > room)
                    return damaged(phrase("one of its code tables has more codes than there can be"));
                room -= unsigned(content[length]) << (16 - length);
            }
            if (content.size() < 17 + symbols)
                return damaged(phrase("one of its code tables is cut off"));
            const Bytes values = content.subspan(17, symbols);
            code.symbols.assign(values.begin(), values.end());
            codes_[content[0] >> 4][content[0] & 3] = std::move(code);
            content = content.subspan(17 + symbols);
        }
    }

    void quantisation(Bytes content) {
        while (!content.empty()) {
            const bool wide = content[0] >> 4 != 0;
            const std::size_t bytes = 1 + (wide ? 128 : 64);
            if (content.size() < bytes)
                return damaged(phrase("one of its quantisation tables is cut off"));
            dcSteps_[content[0] & 3] = wide ? word(content, 1) : content[1];
            content = content.subspan(bytes);
        }
    }

    void scan(Bytes content) {
        if (found_.kind == JpegStream::Kind::none || content.size() < 6 || content[0] != 1)
            return damaged(phrase("a scan of it does not fit its frame"));
        JpegScan scan;
        scan.dc = codes_[0][content[2] >> 4 & 3];
        scan.ac = codes_[1][content[2] & 3];
        scan.first = content[3];
        scan.last = content[4];
        scan.high = content[5] >> 4;
        scan.low = content[5] & 0x0F;
        scan.dcStep = dcSteps_[quantisationTable_];
        scan.restartInterval = restartInterval_;
        codedData(scan);
        found_.scans.push_back(std::move(scan));
    }

    /// Takes everything up to the next marker that is not a restart marker.
    void codedData(JpegScan& scan) {
        std::size_t start = at_;
        for (; at_ + 1 < stream_.size(); ++at_) {
            if (stream_[at_] != 0xFF || stream_[at_ + 1] == 0)
                continue;
            if (!isRestart(stream_[at_ + 1])) {
                scan.parts.push_back(stream_.subspan(start, at_ - start));
                return;
            }
            if (stream_[at_ + 1] != 0xD0 + scan.parts.size() % 8)
                return damaged(phrase("its restart markers are out of order"));
            scan.parts.push_back(stream_.subspan(start, at_ - start));
            start = ++at_ + 1;
        }
        damaged(phrase("it ends without its end marker"));
    }

    Bytes stream_;
    std::size_t at_ = 0;
    bool ended_ = false;
    JpegStream found_;
    std::array<std::array<std::optional<HuffmanCode>, 4>, 2> codes_;
    std::array<int, 4> dcSteps_{1, 1, 1, 1};
    int quantisationTable_ = 0;
    int restartInterval_ = 0;
};

}  // namespace

JpegStream readJpeg(Bytes stream) {
    return Reader(stream).read();
}

}  // namespace pdr::dicom
