package dev.twister.cli.file;

/** The exit codes of the process. */
public final class ExitCode {
    public static final int OK = 0;

    /** An engine failed, or a picture is not what it must be. */
    public static final int FAILED = 1;

    /** Options, a file or a scene that cannot be used. */
    public static final int BAD_INPUT = 2;

    private ExitCode() {}
}
