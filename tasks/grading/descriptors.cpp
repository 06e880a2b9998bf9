// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/descriptors.h"

#include <array>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace cradle {

namespace {

constexpr std::size_t mostDescriptors = 2; ///< with one message

/// A pair of connected sockets of this type; nullopt if there is none to be had.
std::optional<std::pair<Descriptor, Descriptor>> socketsOf(int type)
{
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, type | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return std::nullopt;
    return std::pair(Descriptor(ends[0]), Descriptor(ends[1]));
}

/// Whether \p give, which may take a part of what it gets, took all.
template <typename Give>
bool giveAll(const QByteArray &bytes, const Give &give)
{
    for (qsizetype at = 0; at < bytes.size();) {
        const ssize_t size = TEMP_FAILURE_RETRY(
            give(bytes.constData() + at, static_cast<std::size_t>(bytes.size() - at)));
        if (size <= 0)
            return false;
        at += size;
    }
    return true;
}

} // namespace

Descriptor::~Descriptor()
{
    if (m_number >= 0)
        ::close(m_number);
}

std::optional<std::pair<Descriptor, Descriptor>> connectedPair()
{
    return socketsOf(SOCK_SEQPACKET);
}

std::optional<std::pair<Descriptor, Descriptor>> openPipe()
{
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        return std::nullopt;
    return std::pair(Descriptor(ends[0]), Descriptor(ends[1]));
}

std::optional<std::pair<Descriptor, Descriptor>> openStream()
{
    return socketsOf(SOCK_STREAM);
}

std::optional<QByteArray> readAll(int descriptor, qint64 most)
{
    QByteArray bytes;
    QByteArray part(64 * 1024, Qt::Uninitialized);
    for (;;) {
        const ssize_t size = TEMP_FAILURE_RETRY(
            ::read(descriptor, part.data(), static_cast<std::size_t>(part.size())));
        if (size < 0 || bytes.size() + size > most)
            return std::nullopt;
        if (size == 0)
            return bytes;
        bytes.append(part.constData(), size);
    }
}

bool writeAll(int descriptor, const QByteArray &bytes)
{
    return giveAll(bytes, [descriptor](const char *from, std::size_t size) {
        return ::write(descriptor, from, size);
    });
}

bool sendAll(int stream, const QByteArray &bytes)
{
    return giveAll(bytes, [stream](const char *from, std::size_t size) {
        return ::send(stream, from, size, MSG_NOSIGNAL);
    });
}

bool sendMessage(int socket, const ServerMessage &message, const std::vector<int> &descriptors)
{
    ServerMessage copy = message;
    iovec part{&copy, sizeof copy};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(mostDescriptors * sizeof(int))> room{};
    msghdr header{};
    header.msg_iov = &part;
    header.msg_iovlen = 1;
    if (!descriptors.empty()) {
        const std::size_t bytes = descriptors.size() * sizeof(int);
        header.msg_control = room.data();
        header.msg_controllen = CMSG_SPACE(bytes);
        cmsghdr *control = CMSG_FIRSTHDR(&header);
        control->cmsg_level = SOL_SOCKET;
        control->cmsg_type = SCM_RIGHTS;
        control->cmsg_len = CMSG_LEN(bytes);
        std::memcpy(CMSG_DATA(control), descriptors.data(), bytes);
    }
    const ssize_t sent = TEMP_FAILURE_RETRY(::sendmsg(socket, &header, MSG_NOSIGNAL));
    return sent == static_cast<ssize_t>(sizeof copy);
}

std::optional<ReceivedMessage> receiveMessage(int socket)
{
    ReceivedMessage received;
    iovec part{&received.message, sizeof received.message};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(mostDescriptors * sizeof(int))> room{};
    msghdr header{};
    header.msg_iov = &part;
    header.msg_iovlen = 1;
    header.msg_control = room.data();
    header.msg_controllen = room.size();
    const ssize_t size = TEMP_FAILURE_RETRY(::recvmsg(socket, &header, MSG_CMSG_CLOEXEC));
    for (cmsghdr *control = CMSG_FIRSTHDR(&header); size >= 0 && control;
         control = CMSG_NXTHDR(&header, control)) {
        if (control->cmsg_level != SOL_SOCKET || control->cmsg_type != SCM_RIGHTS)
            continue;
        const std::size_t count = (control->cmsg_len - CMSG_LEN(0)) / sizeof(int);
        for (std::size_t i = 0; i < count; ++i) {
            int number = -1;
            std::memcpy(&number, CMSG_DATA(control) + i * sizeof(int), sizeof number);
            received.descriptors.emplace_back(number);
        }
    }
    if (size != static_cast<ssize_t>(sizeof received.message))
        return std::nullopt;
    return received;
}

} // namespace cradle
