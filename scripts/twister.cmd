@echo off
rem Starts Twister on Windows: finds a JDK, builds where that is needed, and runs with TornadoVM where its SDK is found.
rem Any name may hold a parenthesis, an ampersand, a percent sign. So no variable stands within a block in parentheses, which
rem it could end; none is a word of call, which would read it anew; and what is said goes through :say.
setlocal EnableExtensions DisableDelayedExpansion

for %%I in ("%~dp0..") do set "TWISTER_HOME=%%~fI"
set "target=%TWISTER_HOME%\target"
set "jar=%target%\twister.jar"
set "stamp=%target%\built-with"
set "message=a semicolon in the name of %TWISTER_HOME% would part Java's class path; give Twister another folder"
if not "%TWISTER_HOME:;=%"=="%TWISTER_HOME%" goto fail

set "jdk="
if defined JAVA_HOME set "candidate=%JAVA_HOME:"=%"
if defined JAVA_HOME call :try_jdk
for /f "delims=" %%I in ('where javac 2^>nul') do set "candidate=%%~dpI.."& call :try_jdk
for /d %%I in ("%ProgramFiles%\Eclipse Adoptium\jdk-*" "%ProgramFiles%\Java\jdk-*" "%ProgramFiles%\Microsoft\jdk-*" "%ProgramFiles%\Zulu\zulu-*" "%ProgramFiles%\GraalVM\*" "%USERPROFILE%\.jdks\*" "%USERPROFILE%\.sdkman\candidates\java\*" "%USERPROFILE%\scoop\apps\*") do set "candidate=%%~I"& call :try_jdk
set "message=no JDK 25 or newer was found; install one (Temurin, say) and set JAVA_HOME to its folder"
if not defined jdk goto fail

set "sdk="
if defined TORNADOVM_HOME set "candidate=%TORNADOVM_HOME:"=%"
if defined TORNADOVM_HOME if exist "%candidate%\tornado-argfile" set "sdk=%candidate%"
set "candidate=%USERPROFILE%\.sdkman\candidates\tornadovm\current"
if not defined sdk if exist "%candidate%\tornado-argfile" set "sdk=%candidate%"

rem Commands that use no engine start faster without the modules and options of the engines.
set engines="@%TWISTER_HOME%\scripts\engine.options"
for %%C in (-h --help -V --version denoise explain join scene simulate sky) do if "%~1"=="%%C" set "engines="
for %%C in (-h --help) do if "%~2"=="%%C" set "engines="
if not defined engines set "sdk="

call :is_built
if errorlevel 1 call :build
if errorlevel 1 goto fail

rem The user's collector wins: the JVM takes one.
set collector="@%TWISTER_HOME%\scripts\collector.options"
for %%V in (JAVA_TOOL_OPTIONS JDK_JAVA_OPTIONS TWISTER_JAVA_OPTIONS _JAVA_OPTIONS) do set %%V 2>nul | findstr /r /c:"-XX:+Use[A-Za-z0-9]*GC\>" >nul && set "collector="
rem GraalVM has Graal as a library, and takes it for C2's place; it does not turn the Vector API into instructions. The user's choice wins.
set "jit="
if exist "%jdk%\bin\jvmcicompiler.dll" set jit="@%TWISTER_HOME%\scripts\jit.options"
for %%V in (JAVA_TOOL_OPTIONS JDK_JAVA_OPTIONS TWISTER_JAVA_OPTIONS _JAVA_OPTIONS) do set %%V 2>nul | findstr /r /c:"-XX:[+-]UseJVMCICompiler" /c:"-XX:[+-]UseGraalJIT" >nul && set "jit="
:run
if defined sdk goto run_with_sdk
"%jdk%\bin\java" "@%TWISTER_HOME%\scripts\jvm.options" %engines% %collector% %jit% %TWISTER_JAVA_OPTIONS% -cp "%jar%;%target%\lib\*" dev.twister.cli.Main %*
exit /b

:run_with_sdk
set "engine=%target%\tornado"
if defined LOCALAPPDATA set "engine=%LOCALAPPDATA%\twister\tornado"
set "message=cannot write in %engine%"
if not exist "%engine%\" mkdir "%engine%"
if not exist "%engine%\" goto fail
call :is_engine_built
if errorlevel 1 call :build_engine
if errorlevel 2 goto go_without_sdk
if errorlevel 1 goto fail
set "TORNADOVM_HOME=%sdk%"
"%jdk%\bin\java" "@%engine%\argfile" "@%TWISTER_HOME%\scripts\tornado.options" "@%TWISTER_HOME%\scripts\jvm.options" %engines% %collector% %jit% %TWISTER_JAVA_OPTIONS% -cp "%jar%;%target%\lib\*;%engine%\classes" dev.twister.cli.Main %*
exit /b

rem A JDK without what the SDK's argument file names (JVMCI, say) still runs everything that needs no device.
:go_without_sdk
call :say
set "sdk="
goto run

:fail
call :say
exit /b 2

rem Delayed, a variable is only text, whatever it holds.
:say
setlocal EnableDelayedExpansion
>&2 echo(twister: !message!
exit /b 0

:try_jdk
if defined jdk exit /b 0
if not exist "%candidate%\bin\javac.exe" exit /b 0
if not exist "%candidate%\release" exit /b 0
set "major=0"
for /f "usebackq tokens=1,2 delims==." %%U in ("%candidate%\release") do if "%%U"=="JAVA_VERSION" set "major=%%V"
rem The release file quotes the whole version, so that its first part begins with a quote.
set "major=%major:"=%"
for /f "tokens=1 delims=-+" %%V in ("%major%") do set "major=%%V"
if %major% geq 25 for %%J in ("%candidate%") do set "jdk=%%~fJ"
exit /b 0

:is_built
if not exist "%jar%" exit /b 1
if not exist "%stamp%" exit /b 1
set "built_with="
set /p built_with=<"%stamp%"
if not "%built_with%"=="no sdk" exit /b 1
powershell -NoProfile -Command "$built = (Get-Item -LiteralPath $env:stamp).LastWriteTime; Set-Location -LiteralPath $env:TWISTER_HOME; $newer = @(Get-Item pom.xml, src/main, src/lanes); $newer += Get-ChildItem -Recurse src/main, src/lanes, .mvn -ErrorAction SilentlyContinue; if ($newer | Where-Object { $_.LastWriteTime -gt $built }) { exit 1 }"
exit /b

:build
>&2 echo building Twister: compiling takes about half a minute, after downloads at the first build...
if exist "%target%\program" rmdir /s /q "%target%\program"
if not exist "%target%" mkdir "%target%"
rem What is there afterwards is new.
if exist "%jar%" del "%jar%"
rem The sources' state is that of now, whatever is edited while the build runs.
set "message=cannot write in %target% to build Twister"
if exist "%stamp%.new" del "%stamp%.new"
>"%stamp%.new" echo no sdk
if not exist "%stamp%.new" exit /b 1
set "message=the build failed; its messages are above"
setlocal
set "JAVA_HOME=%jdk%"
pushd "%TWISTER_HOME%"
call mvnw.cmd -q "-P-tornadovm-home,-tornadovm-sdkman" -Pprogram package 1>&2
set "maven_code=%ERRORLEVEL%"
popd
endlocal& set "maven_code=%maven_code%"
if not "%maven_code%"=="0" exit /b 1
if not exist "%jar%" exit /b 1
move /y "%stamp%.new" "%stamp%" >nul
exit /b

rem TornadoVM's engine is built against a user's SDK, and so into the user's folder. PowerShell takes the names from the
rem environment, where they have all their letters.
:is_engine_built
powershell -NoProfile -Command "$files = @(Get-Item -LiteralPath $env:jar, (Join-Path $env:sdk 'tornado-argfile')) + @(Get-ChildItem -Recurse -File -LiteralPath (Join-Path $env:TWISTER_HOME 'src/tornado')); $facts = @($env:sdk, $env:jdk) + @($files | ForEach-Object { $_.FullName + ' ' + $_.Length + ' ' + $_.LastWriteTimeUtc.Ticks }) -join [char]10; $known = Join-Path $env:engine 'built-for'; [IO.File]::WriteAllText($known + '.new', $facts); if (-not (Test-Path -LiteralPath $known) -or [IO.File]::ReadAllText($known) -cne $facts) { exit 1 }"
exit /b

:build_engine
setlocal
rem The user's options are for Twister, not for what it is made by.
set "JAVA_TOOL_OPTIONS="
set "JDK_JAVA_OPTIONS="
set "_JAVA_OPTIONS="
>&2 echo building Twister's engine for TornadoVM...
if exist "%engine%\built-for" del "%engine%\built-for"
if exist "%engine%\classes" rmdir /s /q "%engine%\classes"
rem The current folder is on the module path there: a stray jar would stop the JVM. The collector is Twister's choice. The JVM
rem reads the file in the system's code page.
powershell -NoProfile -Command "$bytes = [IO.File]::ReadAllBytes((Join-Path $env:sdk 'tornado-argfile')); try { $text = (New-Object Text.UTF8Encoding($false, $true)).GetString($bytes) } catch { $text = [Text.Encoding]::Default.GetString($bytes) }; $text = $text -replace '(?m)^(--module-path[ =]\x22?)\.;', '$1' -replace '(?m)^-XX:\+Use[A-Za-z0-9]*GC\s*$', ''; [IO.File]::WriteAllText((Join-Path $env:engine 'argfile'), $text, [Text.Encoding]::Default)"
"%jdk%\bin\java" "@%engine%\argfile" "@%TWISTER_HOME%\scripts\tornado.options" -version >nul 2>&1
if errorlevel 1 goto wrong_sdk
"%jdk%\bin\javac" -g -parameters -proc:none -nowarn -cp "%jar%" --module-path "%sdk%\share\java\tornado" --add-modules tornado.api -d "%engine%\classes" "%TWISTER_HOME%\src\tornado\java\dev\twister\engine\tornado\*.java" 1>&2
if errorlevel 1 goto other_api
xcopy /e /i /q /y "%TWISTER_HOME%\src\tornado\resources" "%engine%\classes" >nul
if errorlevel 1 goto engine_failed
move /y "%engine%\built-for.new" "%engine%\built-for" >nul
exit /b

:engine_failed
endlocal
set "message=the build failed; its messages are above"
exit /b 1

:wrong_sdk
endlocal
set "message=the TornadoVM SDK in %sdk% does not run on the JDK in %jdk%; going on without TornadoVM. Set JAVA_HOME to the JDK that the SDK is made for, or install an SDK made for this one"
exit /b 2

:other_api
endlocal
set "message=the TornadoVM SDK in %sdk% has another API than Twister's engine needs; javac's messages are above; going on without TornadoVM. Install an SDK that was tested (docs/devices.md)"
exit /b 2
