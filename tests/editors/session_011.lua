-- A session of Neovim 0.11 set up as docs/editors.md says, by editors/nvim/ifs.lua alone: the server is started by
-- vim.lsp.config. nvim --headless --clean -l session_011.lua
-- with IFS_PROGRAM, IFS_SETUP (editors/nvim/ifs.lua), IFS_DESIGN and IFS_REPORT (where it says what it saw, as JSON).
local saw = {}

local function session()
  vim.g.ifs_program = vim.env.IFS_PROGRAM
  vim.cmd('source ' .. vim.fn.fnameescape(vim.env.IFS_SETUP))
  vim.cmd('edit ' .. vim.fn.fnameescape(vim.env.IFS_DESIGN))
  local buffer = vim.api.nvim_get_current_buf()
  saw.filetype = vim.bo[buffer].filetype
  local function client() return vim.lsp.get_clients({ bufnr = buffer, name = 'ifs' })[1] end
  assert(vim.wait(20000, function() return client() and client().initialized end, 20), 'no client')
  saw.root = client().root_dir

  local function lines() return vim.api.nvim_buf_get_lines(buffer, 0, -1, false) end
  local function go(text, offset)
    for number, line in ipairs(lines()) do
      local column = line:find(text, 1, true)
      if column then return vim.api.nvim_win_set_cursor(0, { number, column - 1 + (offset or 0) }) end
    end
    error('no ' .. text)
  end
  local function ask(method, more)
    local params = vim.tbl_extend('force', vim.lsp.util.make_position_params(0, client().offset_encoding), more or {})
    local answer = assert(client():request_sync(method, params, 10000, buffer))
    assert(not answer.err, method .. vim.inspect(answer))
    return answer.result
  end

  vim.wait(20000, function() return #vim.diagnostic.get(buffer) > 0 end, 20)
  saw.errors = vim.tbl_map(function(one)
    return { message = one.message, word = lines()[one.lnum + 1]:sub(one.col + 1, one.end_col) }
  end, vim.diagnostic.get(buffer))
  go('hieght')
  local actions = ask('textDocument/codeAction', {
    range = vim.lsp.util.make_range_params(0, client().offset_encoding).range, context = { diagnostics = {} },
  })
  vim.lsp.util.apply_workspace_edit(actions[1].edit, client().offset_encoding)
  saw.mended = vim.wait(20000, function() return #vim.diagnostic.get(buffer) == 0 end, 20)
  go('let height', 5)
  saw.hover = ask('textDocument/hover').contents.value
  vim.lsp.buf.rename('rise')
  vim.wait(10000, function() return table.concat(lines(), '\n'):find('let rise', 1, true) ~= nil end, 20)
  vim.lsp.buf.format({ timeout_ms = 10000 })
  saw.lines = lines()
  vim.lsp.inlay_hint.enable(true, { bufnr = buffer })
  vim.wait(10000, function() return #vim.lsp.inlay_hint.get({ bufnr = buffer }) > 0 end, 20)
  saw.hints = vim.tbl_map(function(hint) return hint.inlay_hint.label end, vim.lsp.inlay_hint.get({ bufnr = buffer }))
  -- They are there when the design has been worked out.
  vim.wait(20000, function()
    vim.lsp.codelens.refresh({ bufnr = buffer })
    return vim.wait(500, function() return #vim.lsp.codelens.get(buffer) > 0 end, 20)
  end, 20)
  saw.lenses = vim.tbl_map(function(lens) return lens.command.title end, vim.lsp.codelens.get(buffer))
end

local good, failure = xpcall(session, debug.traceback)
if not good then saw.failure = failure end
local file = assert(io.open(vim.env.IFS_REPORT, 'w'))
file:write(vim.json.encode(saw))
file:close()
for _, client in pairs(vim.lsp.get_clients()) do client:stop() end
vim.wait(3000, function() return #vim.lsp.get_clients() == 0 end)
vim.cmd('qall!')
