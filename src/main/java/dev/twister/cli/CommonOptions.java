package dev.twister.cli;

import picocli.CommandLine;

/** The options that every command has, before its name or after it. */
final class CommonOptions {
    static final String QUIET = "--quiet";
    static final String VERBOSE = "--verbose";

    private CommonOptions() {}

    static boolean isGiven(String option, CommandLine command) {
        for (CommandLine above = command; above != null; above = above.getParent()) {
            if (above.getParseResult() != null && above.getParseResult().hasMatchedOption(option)) {
                return true;
            }
        }
        return false;
    }
}
