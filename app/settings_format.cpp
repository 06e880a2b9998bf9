// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings_format.h"

#include <QDataStream>
#include <QFileDevice>
#include <QJsonDocument>
#include <QJsonObject>

namespace cradle {

namespace {

constexpr auto streamVersion = QDataStream::Qt_6_4;
const QString streamKey = QStringLiteral("stream");

/// Plain values as such, all others as the text of their bytes.
QJsonValue jsonOf(const QVariant &value)
{
    switch (value.typeId()) {
    case QMetaType::Bool:
    case QMetaType::Int:
    case QMetaType::Double:
    case QMetaType::QString:
        return QJsonValue::fromVariant(value);
    default:
        break;
    }
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream.setVersion(streamVersion);
    stream << value;
    return QJsonObject{{streamKey, QString::fromLatin1(bytes.toBase64())}};
}

QVariant valueFrom(const QJsonValue &json)
{
    if (!json.isObject())
        return json.toVariant();
    QVariant value;
    QDataStream stream(
        QByteArray::fromBase64(json.toObject().value(streamKey).toString().toLatin1()));
    stream.setVersion(streamVersion);
    stream >> value;
    return stream.status() == QDataStream::Ok ? value : QVariant();
}

bool read(QIODevice &device, QSettings::SettingsMap &map)
{
    const QByteArray text = device.readAll();
    const QJsonDocument document = QJsonDocument::fromJson(text);
    const QJsonObject json = document.object();
    for (auto it = json.begin(); it != json.end(); ++it)
        map.insert(it.key(), valueFrom(it.value()));
    return text.isEmpty() || document.isObject();
}

bool write(QIODevice &device, const QSettings::SettingsMap &map)
{
    QJsonObject json;
    for (auto it = map.begin(); it != map.end(); ++it)
        json.insert(it.key(), jsonOf(it.value()));
    const QByteArray text = QJsonDocument(json).toJson();
    if (device.write(text) != text.size())
        return false;
    // Qt 6.4 asks for no more than this: what is only in the buffer may never reach the disk.
    auto *file = qobject_cast<QFileDevice *>(&device);
    return !file || file->flush();
}

} // namespace

QSettings::Format settingsFormat()
{
    static const QSettings::Format format =
        QSettings::registerFormat(QStringLiteral("json"), read, write);
    return format;
}

void takeOlderSettings(QSettings &settings, const QSettings &older)
{
    if (!settings.allKeys().isEmpty())
        return;
    const QStringList keys = older.allKeys();
    for (const QString &key : keys)
        settings.setValue(key, older.value(key));
}

} // namespace cradle
