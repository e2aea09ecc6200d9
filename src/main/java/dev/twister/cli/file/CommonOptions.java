package dev.twister.cli.file;

import picocli.CommandLine;

/** The options that every command has, before its name or after it. */
public final class CommonOptions {
    public static final String QUIET = "--quiet";
    public static final String VERBOSE = "--verbose";

    private CommonOptions() {}

    public static boolean isGiven(String option, CommandLine command) {
        for (CommandLine above = command; above != null; above = above.getParent()) {
            if (above.getParseResult() != null && above.getParseResult().hasMatchedOption(option)) {
                return true;
            }
        }
        return false;
    }
}
