// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <utility>
#include <variant>

namespace cradle {

/// What went wrong, where, and (in the message) what would be right.
struct Error {
    QString message;
    QString file{};    ///< path as the user gave it; empty if there is no file
    QString pointer{}; ///< JSON pointer (RFC 6901) to the value; empty if none or the root
    int line = 0;      ///< from 1; 0 if unknown

    /// "FILE:LINE: message", "FILE: /pointer: message" or "message".
    [[nodiscard]] QString toString() const
    {
        QString text;
        if (!file.isEmpty())
            text += file + (line > 0 ? QStringLiteral(":%1: ").arg(line) : QStringLiteral(": "));
        if (!pointer.isEmpty())
            text += pointer + QStringLiteral(": ");
        return text + message;
    }
    friend bool operator==(const Error &, const Error &) = default;
};

/// A value, or the error that kept us from it.
template <typename T>
class [[nodiscard]] Result
{
public:
    Result(T value)
        : m_content(std::in_place_index<0>, std::move(value))
    {
    }
    Result(Error error)
        : m_content(std::in_place_index<1>, std::move(error))
    {
    }

    [[nodiscard]] bool ok() const { return m_content.index() == 0; }
    explicit operator bool() const { return ok(); }

    /// The value; only when ok().
    [[nodiscard]] const T &value() const { return std::get<0>(m_content); }
    [[nodiscard]] T &value() { return std::get<0>(m_content); }
    const T &operator*() const { return value(); }
    T &operator*() { return value(); }
    const T *operator->() const { return &value(); }
    T *operator->() { return &value(); }

    /// The error; only when not ok().
    [[nodiscard]] const Error &error() const { return std::get<1>(m_content); }

private:
    std::variant<T, Error> m_content;
};

} // namespace cradle
