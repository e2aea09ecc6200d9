package dev.twister.cli;

import java.io.PrintWriter;
import java.io.StringWriter;

/** Exit code and output of one command line. */
public record Outcome(int exitCode, String out, String err) {
    public static Outcome of(String... arguments) {
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        int exitCode = Main.run(new PrintWriter(out, true), new PrintWriter(err, true), arguments);
        return new Outcome(exitCode, out.toString(), err.toString());
    }
}
