// SPDX-License-Identifier: MIT
#include "store/write_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>

#include "core/error.h"
#include "store/read_file.h"
#include "store/temporary_folder.h"

using namespace crumple;
using test::TemporaryFolder;

namespace {

std::vector<std::byte> bytes_of(const std::string& text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

std::string complaint_of(const std::string& path, const std::string& text = "new") {
    try {
        store::write_file(path, bytes_of(text));
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::file);
        return error.what();
    }
    return "";
}

}

TEST(WriteFile, WritesAnEmptyFile) {
    const TemporaryFolder folder;
    store::write_file(folder.file("empty"), {});
    EXPECT_TRUE(store::read_file(folder.file("empty")).empty());
}

TEST(WriteFile, ReplacesTheOldFileAndLeavesNothingElse) {
    const TemporaryFolder folder;
    store::write_file(folder.file("a"), bytes_of("a longer old text"));
    store::write_file(folder.file("a"), bytes_of("new"));
    EXPECT_EQ(store::read_file(folder.file("a")), bytes_of("new"));
    EXPECT_EQ(folder.entry_count(), 1u);
}

TEST(WriteFile, SaysThatTheFolderIsMissing) {
    const TemporaryFolder folder;
    EXPECT_NE(complaint_of(folder.file("no/such/file")).find("does not exist"), std::string::npos);
    EXPECT_THROW(store::check_can_write(folder.file("no/such/file")), Error);
}

TEST(WriteFile, SaysThatTheTargetIsAFolder) {
    const TemporaryFolder folder;
    EXPECT_NE(complaint_of(folder.path().string()).find("it is a folder"), std::string::npos);
    EXPECT_NE(complaint_of(folder.path().string() + "/").find("names no file"), std::string::npos);
    EXPECT_FALSE(complaint_of("").empty());
    EXPECT_EQ(folder.entry_count(), 0u);
}

TEST(WriteFile, RefusesWhatIsNoPlainFile) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
    EXPECT_NE(complaint_of(folder.file("pipe")).find("not a plain file"), std::string::npos);
    EXPECT_THROW((void)store::read_file(folder.file("pipe")), Error) << "and does not wait for a writer";
}

TEST(WriteFile, DoesNotReplaceAFileThatIsReadOnly) {
    const TemporaryFolder folder;
    store::write_file(folder.file("a"), bytes_of("old"));
    std::filesystem::permissions(folder.file("a"), std::filesystem::perms(0444));
    EXPECT_NE(complaint_of(folder.file("a")).find("chmod u+w"), std::string::npos);
    EXPECT_THROW(store::check_can_write(folder.file("a")), Error);
    EXPECT_EQ(store::read_file(folder.file("a")), bytes_of("old"));
    std::filesystem::permissions(folder.file("a"), std::filesystem::perms(0644));
    store::write_file(folder.file("a"), bytes_of("new"));
    EXPECT_EQ(store::read_file(folder.file("a")), bytes_of("new"));
}

// In a child that is nobody, because root may write everywhere.
TEST(WriteFile, SaysThatTheFolderIsReadOnlyAndKeepsTheOldFile) {
    const TemporaryFolder folder;
    store::write_file(folder.file("a"), bytes_of("old"));
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
    const pid_t child = ::fork();
    if (child == 0) {
        constexpr uid_t nobody = 65534;
        if (::geteuid() == 0 && ::seteuid(nobody) != 0) ::_exit(2);
        bool is_refused = complaint_of(folder.file("a")).find("Permission denied") != std::string::npos;
        try {
            store::check_can_write(folder.file("a"));
            is_refused = false;
        } catch (const Error&) {
        }
        ::_exit(is_refused ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    EXPECT_EQ(store::read_file(folder.file("a")), bytes_of("old"));
}

TEST(WriteFile, FollowsALinkAndKeepsIt) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path() / "deep");
    std::filesystem::create_symlink("deep/target", folder.file("link"));
    store::write_file(folder.file("link"), bytes_of("new"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
    EXPECT_EQ(store::read_file(folder.file("deep/target")), bytes_of("new"));
}

TEST(WriteFile, EndsOnLinksThatGoInCircles) {
    const TemporaryFolder folder;
    std::filesystem::create_symlink("b", folder.file("a"));
    std::filesystem::create_symlink("a", folder.file("b"));
    EXPECT_NE(complaint_of(folder.file("a")).find("too many links"), std::string::npos);
}

TEST(WriteFile, TakesTheUsualPermissions) {
    const TemporaryFolder folder;
    const mode_t before = ::umask(022);
    store::write_file(folder.file("a"), bytes_of("new"));
    ::umask(before);
    struct stat status {};
    ASSERT_EQ(::stat(folder.file("a").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777u, 0644u);
}

// In a child, because a limit cannot be taken back. Exit 0: the error said why and everything was left as it was.
TEST(WriteFile, SurvivesAFullDiskAndLeavesTheOldFile) {
    const TemporaryFolder folder;
    store::write_file(folder.file("a"), bytes_of("old"));
    const pid_t child = ::fork();
    if (child == 0) {
        const rlimit limit{4096, 4096};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        const std::string complaint = complaint_of(folder.file("a"), std::string(100000, 'x'));
        ::_exit(complaint.find("size limit") != std::string::npos ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status)) << "SIGXFSZ must not kill";
    EXPECT_EQ(WEXITSTATUS(status), 0);
    EXPECT_EQ(store::read_file(folder.file("a")), bytes_of("old"));
    EXPECT_EQ(folder.entry_count(), 1u) << "the temporary is gone";
}

TEST(ReadFile, SaysWhyItCannot) {
    const TemporaryFolder folder;
    const auto complaint = [](const std::string& path) -> std::string {
        try {
            (void)store::read_file(path);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::file);
            return error.what();
        }
        return "";
    };
    EXPECT_NE(complaint(folder.file("none")).find("No such file"), std::string::npos);
    EXPECT_NE(complaint(folder.path().string()).find("it is a folder"), std::string::npos);
    EXPECT_FALSE(complaint("/dev/zero").empty()) << "a device has no end";
}
