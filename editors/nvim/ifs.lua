-- ifs in Neovim: the file type, and the language server `ifs lsp`. Put it into ~/.config/nvim/plugin/ifs.lua.
-- Neovim 0.11 and later start the server through vim.lsp.config; older ones (from 0.7) through an autocommand.

local program = vim.g.ifs_program or "ifs"

vim.cmd("autocmd BufNewFile,BufRead *.ifs setfiletype ifs")
vim.cmd("autocmd FileType ifs setlocal commentstring=//\\ %s expandtab shiftwidth=4 softtabstop=4")

if vim.lsp.config and vim.lsp.enable then
  vim.lsp.config("ifs", { cmd = { program, "lsp" }, filetypes = { "ifs" }, root_markers = { "ifs.toml", ".git" } })
  vim.lsp.enable("ifs")
else
  -- The server of this session; all designs share it.
  local client

  function _G.ifs_attach(buffer)
    if not client or not vim.lsp.get_client_by_id(client) then
      client = vim.lsp.start_client({ name = "ifs", cmd = { program, "lsp" }, root_dir = vim.fn.getcwd() })
    end
    if client then
      vim.lsp.buf_attach_client(buffer, client)
    end
  end

  vim.cmd("autocmd FileType ifs lua ifs_attach(tonumber(vim.fn.expand('<abuf>')))")
  -- What later versions set by themselves.
  vim.cmd("autocmd FileType ifs setlocal omnifunc=v:lua.vim.lsp.omnifunc")
  vim.cmd("autocmd FileType ifs nnoremap <buffer> K <cmd>lua vim.lsp.buf.hover()<CR>")
  vim.cmd("autocmd FileType ifs nnoremap <buffer> gd <cmd>lua vim.lsp.buf.definition()<CR>")
  vim.cmd("autocmd FileType ifs nnoremap <buffer> grn <cmd>lua vim.lsp.buf.rename()<CR>")
  vim.cmd("autocmd FileType ifs nnoremap <buffer> gra <cmd>lua vim.lsp.buf.code_action()<CR>")
end

-- Colours by the grammar, where its parser is installed.
if vim.treesitter and vim.treesitter.start then
  vim.cmd("autocmd FileType ifs lua pcall(vim.treesitter.start)")
end
