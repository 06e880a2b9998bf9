// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <optional>
#include <utility>
#include <vector>

namespace cradle {

/// Owns an open file of the system.
class Descriptor
{
public:
    Descriptor() = default;
    explicit Descriptor(int number)
        : m_number(number)
    {
    }
    Descriptor(Descriptor &&other) noexcept
        : m_number(std::exchange(other.m_number, -1))
    {
    }
    Descriptor &operator=(Descriptor &&other) noexcept
    {
        std::swap(m_number, other.m_number);
        return *this;
    }
    ~Descriptor();

    [[nodiscard]] int number() const { return m_number; }
    explicit operator bool() const { return m_number >= 0; }
    void close() { *this = Descriptor(); }

private:
    int m_number = -1;
};

/// What goes between the process that grades and the one that forks workers.
struct ServerMessage {
    enum class Kind : int {
        Hello, ///< \c value: flags of what isolation there is
        Judge, ///< come with it: the request and where results go
        Kill,
        Ended ///< \c value: as wait() tells it
    };

    Kind kind = Kind::Hello;
    int worker = 0;
    int value = 0;
};

/// A message that has arrived, with the descriptors that came with it.
struct ReceivedMessage {
    ServerMessage message{};
    std::vector<Descriptor> descriptors{};
};

/// Two ends of a connection that keeps messages whole.
std::optional<std::pair<Descriptor, Descriptor>> connectedPair();
/// The end to read from, then that to write to.
std::optional<std::pair<Descriptor, Descriptor>> openPipe();
/// The end to read from, then that to write to by sendAll(), which does not count as a file.
std::optional<std::pair<Descriptor, Descriptor>> openStream();
/// All that \p descriptor still gives, at most \p most bytes.
[[nodiscard]] std::optional<QByteArray> readAll(int descriptor, qint64 most);
/// \return whether all was written
bool writeAll(int descriptor, const QByteArray &bytes);

/// The same to a stream; waits for who reads. \return false also if the other end is gone
bool sendAll(int stream, const QByteArray &bytes);

/// \return whether it was sent
bool sendMessage(int socket, const ServerMessage &message,
                 const std::vector<int> &descriptors = {});
/// Waits for the next message. \return nothing if the other end is gone
[[nodiscard]] std::optional<ReceivedMessage> receiveMessage(int socket);

} // namespace cradle
