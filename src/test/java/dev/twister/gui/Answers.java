package dev.twister.gui;

import dev.twister.gui.files.FileChoice;
import java.nio.file.Path;
import java.util.Optional;

/** Answers in a person's place: the same file to every question, or none. */
final class Answers implements FileChoice {
    private Optional<Path> next = Optional.empty();
    private Optional<Path> suggested = Optional.empty();

    /** What is chosen from now on. */
    void choose(Path file) {
        next = Optional.of(file);
    }

    /** From now on the person thinks better of it. */
    void chooseNothing() {
        next = Optional.empty();
    }

    /** What was suggested last. */
    Optional<Path> suggested() {
        return suggested;
    }

    @Override
    public Optional<Path> toOpen(Path folder) {
        return answer(folder);
    }

    @Override
    public Optional<Path> toSaveScene(Path suggestion) {
        return answer(suggestion);
    }

    @Override
    public Optional<Path> panorama(Path folder) {
        return answer(folder);
    }

    @Override
    public Optional<Path> picture(Path folder) {
        return answer(folder);
    }

    @Override
    public Optional<Path> mesh(Path folder) {
        return answer(folder);
    }

    @Override
    public Optional<Path> texture(Path folder) {
        return answer(folder);
    }

    @Override
    public Optional<Path> toSavePicture(Path suggestion) {
        return answer(suggestion);
    }

    @Override
    public Optional<Path> toRender(Path suggestion, String kind, String ending) {
        return answer(suggestion);
    }

    @Override
    public Optional<Path> folder(Path suggestion) {
        return answer(suggestion);
    }

    private Optional<Path> answer(Path suggestion) {
        suggested = Optional.of(suggestion);
        return next;
    }
}
