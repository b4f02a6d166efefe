// Files that are cut short, broken, hostile or not files at all, and outputs that cannot be written.
#include <mirrorball/io/image.h>

#include <mirrorball/error.h>

#include "io/samples.h"
#include "io/scratch.h"
#include "io/stb_writer.h"
#include "support/check.h"

#include <csignal>
#include <random>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace mirrorball::io;
using mirrorball::ErrorKind;
using namespace std::string_literals;
using tests::bytesOf;
using tests::store;

namespace {

struct Sample
{
    std::string name;
    std::string bytes;
};

std::vector<Sample> samples(const tests::Scratch& scratch)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> value(0.0f, 1.0f);
    Image noise{31, 17, 4, std::vector<float>(31 * 17 * 4)};
    for (float& pixel : noise.pixels)
        pixel = value(random);
    writePng(scratch / "a.png", noise);
    ExrImage exr = exrFromImage(noise, ExrType::half);
    exr.channels.push_back({"Z", ExrType::single, std::vector<float>(31 * 17, 1.0f)});
    writeExr(scratch / "a.exr", exr);

    std::string planes;
    for (int row = 0; row < 3; ++row)
        planes += "\2\2\0\x09\x89\x80\x09\0\1\2\3\4\5\6\7\x08\x89\0\x89\x88"s;
    return {{"png", bytesOf(scratch / "a.png")},
            {"exr", bytesOf(scratch / "a.exr")},
            {"jpeg", tests::jpeg(19, 21, std::vector<std::uint8_t>(19 * 21 * 3, 77))},
            {"planar hdr", tests::hdr("-Y 3 +X 9", planes)},
            {"flat hdr", tests::hdr("-Y 1 +X 3", "\x80\x80\x80\x81\1\1\1\1\x80\x80\x80\x81")}};
}

void everyTruncationIsNoticed(const tests::Scratch& scratch, const std::vector<Sample>& all)
{
    for (const Sample& sample : all) {
        store(scratch / "x", sample.bytes);
        CHECK(readImage(scratch / "x").width > 0);
        for (std::size_t length = 0; length < sample.bytes.size(); ++length) {
            store(scratch / "x", sample.bytes.substr(0, length));
            CHECK_THROWS(readImage(scratch / "x"), ErrorKind::badFile);
        }
    }
}

// A damaged file is read or refused; what AddressSanitizer and UndefinedBehaviorSanitizer make of it is the
// test.
void everyDamageIsSurvived(const tests::Scratch& scratch, const std::vector<Sample>& all)
{
    std::mt19937 random(2);
    for (const Sample& sample : all)
        for (int round = 0; round < 500; ++round) {
            std::string bytes = sample.bytes;
            // Half of the damage goes into the first 64 bytes, where the sizes are.
            for (int k = 0; k < 1 + round % 3; ++k)
                bytes[random() % (round % 2 == 0 ? bytes.size() : std::size_t{64})] =
                    static_cast<char>(random());
            store(scratch / "x", bytes);
            try {
                const Image image = readImage(scratch / "x");
                CHECK(image.pixels.size() == static_cast<std::size_t>(image.width) *
                                                 static_cast<std::size_t>(image.height) *
                                                 static_cast<std::size_t>(image.channels));
            } catch (const mirrorball::Error& error) {
                CHECK(error.kind() == ErrorKind::badFile);
            }
        }
}

long peakKibibytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

// stb_image 2.27 writes beyond an array on this one (found by everyDamageIsSurvived).
void overfullHuffmanTableIsRefused(const tests::Scratch& scratch, const std::vector<Sample>& all)
{
    std::string bytes = all[2].bytes;
    const std::size_t table = bytes.find("\xff\xc4");
    CHECK(table != std::string::npos);
    bytes.replace(table + 5, 2,
                  "\xff\xff"); // behind marker, length and number: how many codes of 1 bit, of 2 bits
    store(scratch / "x", bytes);
    CHECK_THROWS(readImage(scratch / "x"), ErrorKind::badFile);
}

// Sizes are judged before anything of that size is allocated, and a small picture cannot inflate into a large
// one.
void bombsAreRefused(const tests::Scratch& scratch, const std::vector<Sample>& all)
{
    const std::string exrSample = all[1].bytes;
    std::string hugeExr = exrSample;
    const std::size_t window = exrSample.find("dataWindow\0box2i\0"s) + 17 + 4;
    hugeExr.replace(window, 16, "\0\0\0\x80\0\0\0\x80\xff\xff\xff\x7f\xff\xff\xff\x7f"s);
    std::string hugeAttribute = exrSample;
    hugeAttribute.replace(exrSample.find("compression\0compression\0"s) + 24, 4, "\xff\xff\xff\x7f");
    const std::vector<Sample> bombs = {
        {"png 100000 x 100000", tests::png(100000, 100000, 8, 6, "\0")},
        {"png beyond 31 bits", tests::png(0x40000000, 0x40000000, 8, 6, "\0")},
        {"png of one pixel that inflates to 32 MiB",
         tests::pngOf(1, 1, 8, 0, tests::zlibDeflated(std::string(32 << 20, '\0')))},
        {"png of no width", tests::png(0, 7, 8, 0, "\0")},
        {"hdr beyond 31 bits", tests::hdr("-Y 99999999999 +X 1", "")},
        {"hdr 65536 x 65536",
         tests::hdr("-Y 65536 +X 65536", "\x80\x80\x80\x81\1\1\1\xff\1\1\1\xff\1\1\1\xff")},
        {"hdr of no height", tests::hdr("-Y 0 +X 5", "")},
        {"exr of 2^32 squared", hugeExr},
        {"exr with an attribute of 2 GiB", hugeAttribute},
    };
    for (const Sample& bomb : bombs) {
        store(scratch / "bomb", bomb.bytes);
        // In a child, for a process's peak never falls.
        const pid_t child = fork();
        if (child == 0) {
            const long before = peakKibibytes();
            CHECK_THROWS(readImage(scratch / "bomb"), ErrorKind::badFile);
            // The largest bomb has 210 KiB, which stb may double; the rest is code that is touched first
            // here.
            CHECK(peakKibibytes() - before < 8192);
            std::_Exit(0);
        }
        int status = -1;
        CHECK(waitpid(child, &status, 0) == child);
        CHECK(status == 0);
    }
}

void contentDecidesNotTheName(const tests::Scratch& scratch, const std::vector<Sample>& all)
{
    store(scratch / "really-exr.png", all[1].bytes);
    CHECK(readImage(scratch / "really-exr.png").width == 31);
    // Formats whose decoders are left out.
    for (const std::string& bytes :
         {"GIF89a\1\0\1\0\0\0\0;"s, "8BPS\0\1"s, "BM\x1e\0\0\0"s, "P6 1 1 255\n\1\2\3"s, "\x89"s})
    {
        store(scratch / "x.png", bytes);
        CHECK_THROWS(readImage(scratch / "x.png"), ErrorKind::badFile);
    }
    store(scratch / "x.exr", all[0].bytes);
    CHECK_THROWS(readExr(scratch / "x.exr"), ErrorKind::badFile);
}

void onlyRegularFilesAreRead(const tests::Scratch& scratch)
{
    CHECK_THROWS(readImage(scratch / "missing.png"), ErrorKind::notFound);
    CHECK_THROWS(readImage(scratch / "."), ErrorKind::notFound);
    CHECK_THROWS(readImage(""), ErrorKind::notFound);
    CHECK_THROWS(readImage(std::string(5000, 'x')), ErrorKind::notFound);
    CHECK_THROWS(readImage("/dev/zero"), ErrorKind::notFound);
    CHECK_THROWS(readImage("invalid UTF-8 \xff\xfe"), ErrorKind::notFound);
    CHECK(mkfifo((scratch / "fifo").c_str(), 0600) == 0);
    CHECK_THROWS(readImage(scratch / "fifo"), ErrorKind::notFound);
    std::filesystem::create_symlink("loop", scratch / "loop");
    CHECK_THROWS(readImage(scratch / "loop"), ErrorKind::notFound);
    store(scratch / "empty", "");
    CHECK_THROWS(readImage(scratch / "empty"), ErrorKind::badFile);
}

void aFileAppearsWholeOrNotAtAll()
{
    const tests::Scratch scratch;
    const Image image{1, 1, 3, {1, 1, 1}};
    CHECK_THROWS(writePng(scratch / "no/such/folder.png", image), ErrorKind::unwritable);
    CHECK_THROWS(writePng("/dev/null", image), ErrorKind::unwritable);
    CHECK(!std::filesystem::is_regular_file("/dev/null"));
    std::filesystem::create_directory(scratch / "folder.png");
    CHECK_THROWS(writePng(scratch / "folder.png", image), ErrorKind::unwritable);
    CHECK(scratch.fileCount() == 1);

    // The device is full: a limit on the size of files stands in for it.
    store(scratch / "old.png", "what was there");
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit tiny{16, before.rlim_max};
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &tiny);
    CHECK_THROWS(writePng(scratch / "old.png", image), ErrorKind::unwritable);
    setrlimit(RLIMIT_FSIZE, &before);
    CHECK(bytesOf(scratch / "old.png") == "what was there");
    CHECK(scratch.fileCount() == 2);

    std::filesystem::create_symlink("old.png", scratch / "link.png");
    writePng(scratch / "link.png", image);
    CHECK(std::filesystem::is_symlink(scratch / "link.png"));
    CHECK(readImage(scratch / "old.png").pixels == image.pixels);
    CHECK(scratch.fileCount() == 3);
}

} // namespace

int main()
{
    const tests::Scratch scratch;
    const std::vector<Sample> all = samples(scratch);
    bombsAreRefused(scratch, all);
    everyTruncationIsNoticed(scratch, all);
    everyDamageIsSurvived(scratch, all);
    overfullHuffmanTableIsRefused(scratch, all);
    contentDecidesNotTheName(scratch, all);
    onlyRegularFilesAreRead(scratch);
    aFileAppearsWholeOrNotAtAll();
}
