-- A session of Neovim's own language client with `ifs lsp`: nvim --headless --clean -l is newer than 0.7, so it is run by
--   nvim --headless --clean -c 'luafile session.lua'
-- with IFS_PROGRAM, IFS_DESIGN (a file that may be changed), and IFS_REPORT (where it says what it saw, as JSON).
local program, design, report = vim.env.IFS_PROGRAM, vim.env.IFS_DESIGN, vim.env.IFS_REPORT
local saw = {}

local function finish()
  local file = assert(io.open(report, 'w'))
  file:write(vim.fn.json_encode(saw))
  file:close()
  for _, client in pairs(vim.lsp.get_active_clients()) do client.stop() end
  vim.wait(3000, function() return #vim.lsp.get_active_clients() == 0 end)
  vim.cmd('qall!')
end

local function session()
  vim.cmd('edit ' .. vim.fn.fnameescape(design))
  local buffer = vim.api.nvim_get_current_buf()
  local client_id = vim.lsp.start_client({
    name = 'ifs', cmd = { program, 'lsp' }, root_dir = vim.fn.fnamemodify(design, ':h'),
  })
  vim.lsp.buf_attach_client(buffer, client_id)
  local client = vim.lsp.get_client_by_id(client_id)

  local function lines() return vim.api.nvim_buf_get_lines(buffer, 0, -1, false) end
  -- Line and column, from 1 and 0, where a text begins.
  local function place(text)
    for number, line in ipairs(lines()) do
      local column = line:find(text, 1, true)
      if column then return { number, column - 1 } end
    end
    error('no ' .. text)
  end
  local function ask(method, text, offset, more)
    local at = place(text)
    vim.api.nvim_win_set_cursor(0, { at[1], at[2] + (offset or 0) })
    local params = vim.lsp.util.make_position_params(0, client.offset_encoding)
    for name, value in pairs(more or {}) do params[name] = value end
    local answer = client.request_sync(method, params, 10000, buffer)
    assert(answer and not answer.err, method .. vim.inspect(answer))
    return answer.result
  end
  local function diagnostics(is)
    vim.wait(20000, function() return is(vim.diagnostic.get(buffer)) end, 20)
    local found = {}
    for _, one in ipairs(vim.diagnostic.get(buffer)) do
      local line = lines()[one.lnum + 1] or ''
      found[#found + 1] = {
        code = one.code or (one.user_data and one.user_data.lsp and one.user_data.lsp.code),
        message = one.message, word = line:sub(one.col + 1, one.end_col), line = line,
      }
    end
    return found
  end

  vim.wait(10000, function() return client.initialized end, 20)
  saw.errors = diagnostics(function(list) return #list > 0 end)
  -- Typing mends it; the client sends the change as a range.
  local at = place('hieght')
  vim.api.nvim_buf_set_text(buffer, at[1] - 1, at[2], at[1] - 1, at[2] + 6, { 'height' })
  saw.mended = diagnostics(function(list) return #list == 0 end)
  saw.hover = ask('textDocument/hover', 'let height', 5).contents.value
  saw.definition = ask('textDocument/definition', '(1m, height)', 6)
  local edit = ask('textDocument/rename', '(1m, height)', 6, { newName = 'rise' })
  vim.lsp.util.apply_workspace_edit(edit, client.offset_encoding)
  saw.renamed = lines()
  local options = { tabSize = 4, insertSpaces = true }
  local params = { textDocument = vim.lsp.util.make_text_document_params(buffer), options = options }
  local answer = client.request_sync('textDocument/formatting', params, 10000, buffer)
  vim.lsp.util.apply_text_edits(answer.result, buffer, client.offset_encoding)
  saw.formatted = lines()
  saw.at_last = diagnostics(function(list) return #list == 0 end)
end

local good, why = pcall(session)
if not good then saw.failure = tostring(why) end
finish()
