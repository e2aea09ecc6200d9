package dev.twister.cli;

/** The exit codes of the process. */
final class ExitCode {
    static final int OK = 0;

    /** An engine failed, or a picture is not what it must be. */
    static final int FAILED = 1;

    /** Options, a file or a scene that cannot be used. */
    static final int BAD_INPUT = 2;

    private ExitCode() {}
}
