package dev.twister.files;

/** Pointer files of Git LFS, which stand for large files that were not downloaded. */
public final class GitLfs {
    /** How a pointer file starts, one byte per character. */
    public static final String START = "version https://git-lfs.github.com/spec/";

    public static final String PROBLEM = "a Git LFS pointer, not the file itself; run 'git lfs pull' to download it";

    private GitLfs() {}
}
