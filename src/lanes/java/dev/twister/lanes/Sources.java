package dev.twister.lanes;

import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.ExpressionTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.SourcePositions;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/** Methods and constants of Java files. */
final class Sources {
    /** A method with its class's simple name and its file. */
    record Method(String owner, MethodTree tree, CompilationUnitTree file) {
        String name() {
            return owner + "." + tree.getName();
        }
    }

    private final Map<String, Method> methods = new HashMap<>();
    private final Map<String, ExpressionTree> constants = new HashMap<>();
    private final SourcePositions positions;

    private Sources(SourcePositions positions) {
        this.positions = positions;
    }

    /** Parses files; nothing is looked up elsewhere. */
    static Sources parse(Collection<Path> files) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        try (StandardJavaFileManager manager = compiler.getStandardFileManager(null, null, null)) {
            JavacTask task = (JavacTask) compiler.getTask(
                    null, manager, null, List.of("-proc:none"), null, manager.getJavaFileObjectsFromPaths(files));
            Sources sources = new Sources(Trees.instance(task).getSourcePositions());
            for (CompilationUnitTree file : task.parse()) {
                for (Tree type : file.getTypeDecls()) {
                    if (type instanceof ClassTree declared) {
                        sources.add(declared, file);
                    }
                }
            }
            return sources;
        }
    }

    private void add(ClassTree type, CompilationUnitTree file) {
        String owner = type.getSimpleName().toString();
        for (Tree member : type.getMembers()) {
            if (member instanceof MethodTree method) {
                methods.put(
                        key(
                                owner,
                                method.getName().toString(),
                                method.getParameters().size()),
                        new Method(owner, method, file));
            } else if (member instanceof VariableTree field && field.getInitializer() != null) {
                constants.put(owner + "." + field.getName(), field.getInitializer());
            }
        }
    }

    private static String key(String owner, String name, int parameters) {
        return owner + "." + name + "/" + parameters;
    }

    /** All methods. */
    Collection<Method> methods() {
        return methods.values();
    }

    /** The method with that number of parameters. */
    Method method(String owner, String name, int parameters) {
        return Optional.ofNullable(methods.get(key(owner, name, parameters)))
                .orElseThrow(() -> new Refusal("a call of " + owner + "." + name + ", which the kernel does not have"));
    }

    /** The method of that name, such as {@code Noise.mixed}, which must be the only one. */
    Method method(String name) {
        List<Method> named = methods.values().stream()
                .filter(method -> method.name().equals(name))
                .toList();
        if (named.size() != 1) {
            throw new Refusal("the kernel has " + named.size() + " methods " + name);
        }
        return named.getFirst();
    }

    /** What the constant of a class is set to. */
    ExpressionTree constant(String owner, String name) {
        return Optional.ofNullable(constants.get(owner + "." + name))
                .orElseThrow(() -> new Refusal("an unknown name: " + owner + "." + name));
    }

    /** File and line, such as {@code Noise.java:52}. */
    String place(Method method, Tree tree) {
        String path = method.file().getSourceFile().getName();
        long line = method.file().getLineMap().getLineNumber(positions.getStartPosition(method.file(), tree));
        return path.substring(path.lastIndexOf('/') + 1) + ":" + line;
    }
}
