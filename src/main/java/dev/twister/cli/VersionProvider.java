package dev.twister.cli;

import dev.twister.files.TwisterVersion;
import picocli.CommandLine.IVersionProvider;

/** What {@code --version} prints. */
final class VersionProvider implements IVersionProvider {
    @Override
    public String[] getVersion() {
        return new String[] {"twister " + TwisterVersion.text(), "JDK " + Runtime.version()};
    }
}
