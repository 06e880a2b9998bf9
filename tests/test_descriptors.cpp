// SPDX-FileCopyrightText: 2026 The Cradle authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/grading/descriptors.h"

#include <QTest>

#include <csignal>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

using namespace cradle;

/// What goes between processes arrives whole, or it is said that it does not.
class TestDescriptors : public QObject
{
    Q_OBJECT
private slots:
    void bytesArriveWhole_data();
    void bytesArriveWhole();
    void noMoreIsReadThanIsWanted_data();
    void noMoreIsReadThanIsWanted();
    void nobodyReads();
    void descriptorsComeWithAMessage();
    void noneIsToBeHad();
};

void TestDescriptors::bytesArriveWhole_data()
{
    QTest::addColumn<bool>("isStream");
    QTest::addColumn<int>("size");
    for (const int size : {0, 1, 64 * 1024, 3'000'000}) {
        QTest::addRow("pipe, %d", size) << false << size;
        QTest::addRow("stream, %d", size) << true << size;
    }
}

/// A pipe takes 64 KiB at a time, so that large ones are given in parts.
void TestDescriptors::bytesArriveWhole()
{
    QFETCH(bool, isStream);
    QFETCH(int, size);
    QByteArray bytes(size, '\0');
    for (int i = 0; i < size; ++i)
        bytes[i] = static_cast<char>(i * 7 + i / 1000);
    auto ends = isStream ? openStream() : openPipe();
    QVERIFY(ends);
    bool given = false;
    std::thread writer([&] {
        given = isStream ? sendAll(ends->second.number(), bytes)
                         : writeAll(ends->second.number(), bytes);
        ends->second.close();
    });
    const auto read = readAll(ends->first.number(), 4'000'000);
    writer.join();
    QVERIFY(given && read);
    QVERIFY(*read == bytes);
}

void TestDescriptors::noMoreIsReadThanIsWanted_data()
{
    QTest::addColumn<int>("most");
    QTest::addColumn<bool>("isRead");
    QTest::newRow("as many") << 1000 << true;
    QTest::newRow("one too few") << 999 << false;
}

void TestDescriptors::noMoreIsReadThanIsWanted()
{
    QFETCH(int, most);
    QFETCH(bool, isRead);
    auto ends = openPipe();
    QVERIFY(ends && writeAll(ends->second.number(), QByteArray(1000, 'x')));
    ends->second.close();
    QCOMPARE(readAll(ends->first.number(), most).has_value(), isRead);
    QVERIFY(!readAll(-1, 1000));
}

void TestDescriptors::nobodyReads()
{
    signal(SIGPIPE, SIG_IGN);
    auto pipe = openPipe();
    auto stream = openStream();
    auto messages = connectedPair();
    QVERIFY(pipe && stream && messages);
    pipe->first.close();
    stream->first.close();
    messages->first.close();
    QVERIFY(!writeAll(pipe->second.number(), "x"));
    QVERIFY(!sendAll(stream->second.number(), "x"));
    QVERIFY(!sendMessage(messages->second.number(), {}));
    QVERIFY(!receiveMessage(messages->second.number()));
}

void TestDescriptors::descriptorsComeWithAMessage()
{
    auto messages = connectedPair();
    auto pipe = openPipe();
    QVERIFY(messages && pipe);
    const ServerMessage sent{.kind = ServerMessage::Kind::Judge, .worker = 3, .value = -7};
    QVERIFY(sendMessage(messages->first.number(), sent));
    QVERIFY(
        sendMessage(messages->first.number(), sent, {pipe->first.number(), pipe->second.number()}));
    const auto without = receiveMessage(messages->second.number());
    QVERIFY(without && without->descriptors.empty());
    const auto with = receiveMessage(messages->second.number());
    QVERIFY(with);
    QVERIFY(with->message.kind == sent.kind && with->message.worker == 3
            && with->message.value == -7);
    QCOMPARE(with->descriptors.size(), std::size_t(2));
    for (const Descriptor &each : with->descriptors) // none goes on to programs that are started
        QVERIFY(fcntl(each.number(), F_GETFD) & FD_CLOEXEC);
    pipe->second.close();
    QVERIFY(writeAll(with->descriptors[1].number(), "through"));
    char text[7];
    QCOMPARE(::read(pipe->first.number(), text, sizeof text), ssize_t(7));
    QCOMPARE(QByteArray(text, 7), QByteArray("through"));
}

void TestDescriptors::noneIsToBeHad()
{
    rlimit before{};
    QCOMPARE(getrlimit(RLIMIT_NOFILE, &before), 0);
    const rlimit none{.rlim_cur = 0, .rlim_max = before.rlim_max};
    QCOMPARE(setrlimit(RLIMIT_NOFILE, &none), 0);
    const bool any = openPipe() || openStream() || connectedPair();
    QCOMPARE(setrlimit(RLIMIT_NOFILE, &before), 0);
    QVERIFY(!any);
}

QTEST_GUILESS_MAIN(TestDescriptors)
#include "test_descriptors.moc"
