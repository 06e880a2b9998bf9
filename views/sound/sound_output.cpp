// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sound/sound_output.h"

#include "views/sound/tone.h"

#include <QLibrary>

#include <algorithm>
#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <thread>
#include <utility>

namespace cradle {

namespace {

constexpr std::size_t blockSize = sampleRate / 100;
/// More sounds at once would not be told apart; the oldest gives way.
constexpr std::size_t mostVoices = 16;

// The part of PulseAudio's stable interface that is used here (pulse/simple.h).
constexpr int playback = 1;
constexpr int floatLittleEndian = 5;
struct SampleSpec {
    int format;
    std::uint32_t rate;
    std::uint8_t channels;
};
struct BufferAttributes {
    std::uint32_t maxLength, targetLength, preBuffer, minRequest, fragment;
};
using Open = void *(*)(const char *, const char *, int, const char *, const char *,
                       const SampleSpec *, const void *, const BufferAttributes *, int *);
using Write = int (*)(void *, const void *, std::size_t, int *);
using Close = void (*)(void *);

/// A connection to the sound server.
class Server
{
public:
    Server()
    {
        QLibrary library(QStringLiteral("pulse-simple"), 0);
        const auto open = reinterpret_cast<Open>(library.resolve("pa_simple_new"));
        m_write = reinterpret_cast<Write>(library.resolve("pa_simple_write"));
        m_close = reinterpret_cast<Close>(library.resolve("pa_simple_free"));
        if (!open || !m_write || !m_close)
            return;
        const SampleSpec spec{floatLittleEndian, sampleRate, 1};
        // Short, so that a hit is heard when it is seen; what is not given is the server's choice.
        constexpr std::uint32_t block = blockSize * sizeof(float);
        constexpr std::uint32_t any = ~0U;
        const BufferAttributes buffer{any, 4 * block, block, any, any};
        m_stream =
            open(nullptr, "Cradle", playback, nullptr, "Hits", &spec, nullptr, &buffer, nullptr);
    }
    ~Server()
    {
        if (m_stream)
            m_close(m_stream);
    }
    Q_DISABLE_COPY_MOVE(Server)

    [[nodiscard]] bool isOpen() const { return m_stream != nullptr; }
    [[nodiscard]] bool write(const std::array<float, blockSize> &block)
    {
        return m_write(m_stream, block.data(), block.size() * sizeof(float), nullptr) >= 0;
    }

private:
    void *m_stream = nullptr;
    Write m_write = nullptr;
    Close m_close = nullptr;
};

struct Voice {
    std::vector<float> samples;
    std::size_t at = 0;
};

/// The next block of all \p voices together; those that have ended are taken away.
std::array<float, blockSize> mixed(std::vector<Voice> &voices)
{
    std::array<float, blockSize> block{};
    for (Voice &voice : voices) {
        const std::size_t count = std::min(blockSize, voice.samples.size() - voice.at);
        for (std::size_t i = 0; i < count; ++i)
            block[i] += voice.samples[voice.at + i];
        voice.at += count;
    }
    std::erase_if(voices, [](const Voice &voice) { return voice.at >= voice.samples.size(); });
    for (float &sample : block)
        sample = std::clamp(sample, -1.0F, 1.0F);
    return block;
}

} // namespace

struct SoundOutput::Shared {
    std::mutex mutex;
    std::condition_variable changed;
    std::vector<std::vector<float>> waiting;
    SoundOutput *owner = nullptr; ///< null once it is gone
    bool started = false;
    bool failed = false;
};

SoundOutput::SoundOutput(QObject *parent)
    : QObject(parent)
    , m_shared(std::make_shared<Shared>())
{
    m_shared->owner = this;
}

SoundOutput::~SoundOutput()
{
    const std::lock_guard lock(m_shared->mutex);
    m_shared->owner = nullptr;
    m_shared->changed.notify_one();
}

void SoundOutput::play(std::vector<float> samples)
{
    const std::lock_guard lock(m_shared->mutex);
    if (m_shared->failed || samples.empty())
        return;
    m_shared->waiting.push_back(std::move(samples));
    if (m_shared->waiting.size() > mostVoices)
        m_shared->waiting.erase(m_shared->waiting.begin());
    if (!std::exchange(m_shared->started, true))
        std::thread([shared = m_shared] { run(shared); }).detach();
    m_shared->changed.notify_one();
}

/// The thread. It is never waited for, as opening and writing may take as long as the server likes.
void SoundOutput::run(const std::shared_ptr<Shared> &shared)
{
    Server server;
    std::vector<Voice> voices;
    bool works = server.isOpen();
    while (works) {
        {
            std::unique_lock lock(shared->mutex);
            shared->changed.wait(lock, [&] {
                return !shared->owner || !shared->waiting.empty() || !voices.empty();
            });
            if (!shared->owner)
                return;
            for (std::vector<float> &samples : shared->waiting)
                voices.push_back({.samples = std::move(samples)});
            shared->waiting.clear();
        }
        if (voices.size() > mostVoices)
            voices.erase(voices.begin(), voices.end() - mostVoices);
        works = server.write(mixed(voices));
    }
    const std::lock_guard lock(shared->mutex);
    shared->failed = true;
    shared->waiting.clear();
    if (shared->owner)
        QMetaObject::invokeMethod(shared->owner, &SoundOutput::failed, Qt::QueuedConnection);
}

} // namespace cradle
